// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.h: the linear system of steps along the normals, put together in one pass.
#pragma once

#include "sparse_cholesky.h"

#include <vector>

namespace developable::detail {

/// Of A + ε NᵀWN the lower triangle, where A = (JN)ᵀ(JN): one row and column a place. The pattern is found
/// once; after that numbers are written where they belong, without a sparse matrix in between.
class NormalSystem {
public:
	/// \param metric  the lower triangle of W, which has to outlive this
	explicit NormalSystem(const SparseMatrix& metric) : metric_(metric) {}

	/// \param along    JN, rows x places, always of the same pattern
	/// \param normals  N, 3 x places
	const SparseMatrix& fill(const SparseMatrix& along, const Eigen::Matrix3Xd& normals, double epsilon) {
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

private:
	using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

	void findPattern(const SparseMatrix& along) {
		const SparseMatrix product = along.transpose() * along;
		lower_ = SparseMatrix(product.triangularView<Eigen::Lower>()) + metric_;
		entryOfRow_.resize(lower_.rows());
	}

	const SparseMatrix& metric_;
	SparseMatrix lower_;
	std::vector<double*> entryOfRow_; ///< of the column at work
};

} // namespace developable::detail
