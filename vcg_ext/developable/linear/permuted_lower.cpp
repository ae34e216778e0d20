// SPDX-License-Identifier: GPL-3.0-or-later
// permuted_lower.cpp: finds the places of numbers, and fetches them.
#include "permuted_lower.h"

#include <algorithm>
#include <numeric>

namespace developable {

void PermutedLower::permute(const SparseMatrix& lower, const int* order) {
	if (!hasPattern(lower))
		findSources(lower, order);
	const double* const numbers = lower.valuePtr();
	numbers_.resize(sources_.nonZeros());
	std::transform(sources_.valuePtr(), sources_.valuePtr() + sources_.nonZeros(), numbers_.begin(),
				   [numbers](int source) { return numbers[source]; });
}

bool PermutedLower::hasPattern(const SparseMatrix& lower) const {
	return std::equal(columnStarts_.begin(), columnStarts_.end(), lower.outerIndexPtr(),
					  lower.outerIndexPtr() + lower.cols() + 1) &&
		   std::equal(rows_.begin(), rows_.end(), lower.innerIndexPtr(),
					  lower.innerIndexPtr() + lower.nonZeros());
}

void PermutedLower::findSources(const SparseMatrix& lower, const int* order) {
	columnStarts_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
	rows_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
	std::vector<int> places(lower.nonZeros());
	std::iota(places.begin(), places.end(), 0);
	const Eigen::Map<const Eigen::SparseMatrix<int>> numbered(
		lower.rows(), lower.cols(), lower.nonZeros(), columnStarts_.data(), rows_.data(), places.data());
	Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> newRow(lower.rows());
	for (int row = 0; row < lower.rows(); ++row)
		newRow.indices()[order[row]] = row;
	sources_.resize(lower.rows(), lower.cols());
	sources_.selfadjointView<Eigen::Lower>() = numbered.selfadjointView<Eigen::Lower>().twistedBy(newRow);
}

} // namespace developable
