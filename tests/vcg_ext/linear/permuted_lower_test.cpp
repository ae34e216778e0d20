// SPDX-License-Identifier: GPL-3.0-or-later
// permuted_lower_test.cpp: numbers go where another order of rows and columns has them.
#include "developable/linear/permuted_lower.h"

#include "matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace developable::test {
namespace {

std::vector<int> shuffled(int count) {
	std::vector<int> order(count);
	std::iota(order.begin(), order.end(), 0);
	std::shuffle(order.begin(), order.end(), std::mt19937(7));
	return order;
}

Eigen::MatrixXd whole(const Eigen::MatrixXd& lower) {
	return lower.selfadjointView<Eigen::Lower>();
}

/// How much the permuted matrix differs from what dense matrices say.
double difference(const PermutedLower& permuted, const SparseMatrix& lower, const std::vector<int>& order) {
	const Eigen::MatrixXd found = permuted.matrix(), expected = whole(lower)(order, order);
	const Eigen::MatrixXd above = found.triangularView<Eigen::StrictlyUpper>();
	return (whole(found) - expected).cwiseAbs().maxCoeff() + above.cwiseAbs().maxCoeff();
}

TEST(PermutedLower, HasEveryNumberInItsNewPlace) {
	const SparseMatrix lower = plate(9);
	const std::vector<int> order = shuffled(81);
	PermutedLower permuted;
	permuted.permute(lower, order.data());
	EXPECT_EQ(difference(permuted, lower, order), 0);
	std::vector<int> other = order;
	std::swap(other[0], other[1]);
	EXPECT_GT(difference(permuted, lower, other), 0);
}

TEST(PermutedLower, FetchesOtherNumbersOfTheSamePattern) {
	const std::vector<int> order = shuffled(81);
	PermutedLower permuted;
	permuted.permute(plate(9), order.data());
	permuted.permute(plate(9, 5, 0.3), order.data());
	EXPECT_EQ(difference(permuted, plate(9, 5, 0.3), order), 0);
}

TEST(PermutedLower, FindsThePlacesOfAnotherPattern) {
	const std::vector<int> order = shuffled(81);
	PermutedLower permuted;
	permuted.permute(plate(9), order.data());
	SparseMatrix diagonal(81, 81);
	diagonal.setIdentity();
	permuted.permute(diagonal, order.data());
	EXPECT_EQ(permuted.matrix().nonZeros(), 81);
	EXPECT_EQ(difference(permuted, diagonal, order), 0);
}

TEST(PermutedLower, ReadsTheLowerTriangleOnly) {
	const SparseMatrix lower = plate(9);
	SparseMatrix full = lower.selfadjointView<Eigen::Lower>();
	full.coeffRef(0, 1) = 99; // above the diagonal
	const std::vector<int> order = shuffled(81);
	PermutedLower permuted;
	permuted.permute(full, order.data());
	EXPECT_EQ(difference(permuted, lower, order), 0);
}

} // namespace
} // namespace developable::test
