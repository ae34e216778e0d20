// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.cpp: the pattern of the system, and its numbers.
#include "normal_system.h"

namespace developable::detail {

const SparseMatrix& NormalSystem::fill(const SparseMatrix& along, const Eigen::Matrix3Xd& normals,
									   double epsilon) {
	if (lower_.rows() == 0)
		findPattern(along);
	const RowMajor byRow = along;
	for (int place = 0; place < lower_.outerSize(); ++place) {
		for (SparseMatrix::InnerIterator entry(lower_, place); entry; ++entry) {
			entry.valueRef() = 0;
			entryOfRow_[entry.row()] = &entry.valueRef();
		}
		for (SparseMatrix::InnerIterator own(along, place); own; ++own)
			for (RowMajor::InnerIterator other(byRow, own.row()); other; ++other)
				if (other.col() >= place)
					*entryOfRow_[other.col()] += own.value() * other.value();
		for (SparseMatrix::InnerIterator entry(metric_, place); entry; ++entry)
			*entryOfRow_[entry.row()] +=
				epsilon * entry.value() * normals.col(entry.row()).dot(normals.col(place));
	}
	return lower_;
}

void NormalSystem::findPattern(const SparseMatrix& along) {
	const SparseMatrix product = along.transpose() * along;
	lower_ = SparseMatrix(product.triangularView<Eigen::Lower>()) + metric_;
	entryOfRow_.resize(lower_.rows());
}

} // namespace developable::detail
