// SPDX-License-Identifier: GPL-3.0-or-later
// permuted_lower.h: the lower triangle of a symmetric matrix in another order of its rows and columns.
#pragma once

#include "sparse_cholesky.h"

#include <vector>

namespace developable {

/// Where each number of a symmetric matrix goes in another order is found once for a pattern; after that
/// numbers are only fetched.
class PermutedLower {
public:
	/// \param lower  of it only the lower triangle is read; compressed
	/// \param order  per new row the old one
	void permute(const SparseMatrix& lower, const int* order);

	/// What was permuted last: a lower triangle whose columns are in no order.
	Eigen::Map<const SparseMatrix> matrix() const {
		return {sources_.rows(),          sources_.cols(),          sources_.nonZeros(),
				sources_.outerIndexPtr(), sources_.innerIndexPtr(), numbers_.data()};
	}

private:
	bool hasPattern(const SparseMatrix& lower) const;
	void findSources(const SparseMatrix& lower, const int* order);

	std::vector<int> columnStarts_, rows_; // of the matrix that the sources are for
	Eigen::SparseMatrix<int> sources_;     // per new entry the old one's place among the stored numbers
	std::vector<double> numbers_;
};

} // namespace developable
