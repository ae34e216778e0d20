// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.cpp: the pattern of the system, and its numbers.
#include "normal_system.h"

namespace developable::detail {

void NormalSystem::prepare(const SparseMatrix& along, const SparseMatrix& metric) {
	findPattern(along, metric);
	solver_ = SparseSolver(memoryLimit_);
	solver_.prepare(lower_, eliminationOrder(placeOrder_, perPlace_));
}

bool NormalSystem::factorize(const SparseMatrix& along, const Eigen::Matrix3Xd& directions,
							 const SparseMatrix& metric, double epsilon) {
	if (lower_.rows() == 0 || metric.nonZeros() != metricEntries_)
		prepare(along, metric);
	fill(along, directions, metric, epsilon);
	return solver_.factorize(lower_);
}

void NormalSystem::fill(const SparseMatrix& along, const Eigen::Matrix3Xd& directions,
						const SparseMatrix& metric, double epsilon) {
	const RowMajor byRow = along;
	std::vector<int> nextInRow(byRow.outerIndexPtr(), byRow.outerIndexPtr() + byRow.rows()); // not done yet
	for (int column = 0; column < lower_.outerSize(); ++column) {
		for (SparseMatrix::InnerIterator entry(lower_, column); entry; ++entry) {
			entry.valueRef() = 0;
			entryOfRow_[entry.row()] = &entry.valueRef();
		}
		for (SparseMatrix::InnerIterator own(along, column); own; ++own) {
			const int end = byRow.outerIndexPtr()[own.row() + 1];
			for (int other = nextInRow[own.row()]++; other < end; ++other)
				*entryOfRow_[byRow.innerIndexPtr()[other]] += own.value() * byRow.valuePtr()[other];
		}
		addMetric(directions, metric, column, epsilon);
	}
}

void NormalSystem::addMetric(const Eigen::Matrix3Xd& directions, const SparseMatrix& metric, int column,
							 double epsilon) {
	for (SparseMatrix::InnerIterator entry(metric, column / perPlace_); entry; ++entry)
		for (int i = 0; i < perPlace_; ++i) {
			const int row = perPlace_ * static_cast<int>(entry.row()) + i;
			// Coordinates have nothing to do with each other in W, and may have no entry.
			const double cosine = directions.col(row).dot(directions.col(column));
			if (row >= column && cosine != 0)
				*entryOfRow_[row] += epsilon * entry.value() * cosine;
		}
}

void NormalSystem::findPattern(const SparseMatrix& along, const SparseMatrix& metric) {
	perPlace_ = static_cast<int>(along.cols() / metric.cols());
	metricEntries_ = metric.nonZeros();
	std::vector<Eigen::Triplet<double>> entries;
	entries.reserve(perPlace_ * metricEntries_);
	for (int place = 0; place < metric.outerSize(); ++place)
		for (SparseMatrix::InnerIterator entry(metric, place); entry; ++entry)
			for (int i = 0; i < perPlace_; ++i)
				entries.emplace_back(perPlace_ * entry.row() + i, perPlace_ * place + i, 0);
	SparseMatrix ofMetric(along.cols(), along.cols());
	ofMetric.setFromTriplets(entries.begin(), entries.end());
	const SparseMatrix product = along.transpose() * along;
	lower_ = SparseMatrix(product.triangularView<Eigen::Lower>()) + ofMetric;
	entryOfRow_.resize(lower_.rows());
}

} // namespace developable::detail
