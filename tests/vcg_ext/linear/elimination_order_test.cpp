// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/elimination_order.h"

#include "matrices.h"

#include <gtest/gtest.h>
#include <numeric>

namespace developable::test {
namespace {

void expectPermutation(std::vector<int> order, int rows) {
	std::vector<int> expected(rows);
	std::iota(expected.begin(), expected.end(), 0);
	std::sort(order.begin(), order.end());
	EXPECT_EQ(order, expected);
}

TEST(EliminationOrder, HasEveryRowOnce) {
	const std::vector<int> order = eliminationOrder(plate(31));
	expectPermutation(order, 31 * 31);
	expectPermutation(eliminationOrder(order, 3), 3 * 31 * 31);
	EXPECT_EQ(eliminationOrder({2, 0, 1}, 2), (std::vector<int>{4, 5, 0, 1, 2, 3}));
	EXPECT_EQ(eliminationOrder(order, 1), order);
	SparseMatrix diagonal(4, 4);
	diagonal.setIdentity();
	expectPermutation(eliminationOrder(diagonal), 4);
}

TEST(EliminationOrder, ServesOtherMatricesOfASimilarPattern) {
	const SparseMatrix lower = plate(41);
	const std::vector<int> order = eliminationOrder(lower);
	SparseCholesky own, given;
	const double ownMemory = own.analyze(lower), givenMemory = given.analyze(lower, order);
	EXPECT_NEAR(givenMemory, ownMemory, 0.01 * ownMemory);
	// A membrane has fewer entries than a plate, all of them among its.
	const SparseMatrix membrane = plate(41, 1, 0).pruned(1e-9) + SparseMatrix(lower.rows(), lower.cols());
	EXPECT_LT(SparseCholesky().analyze(membrane, order), givenMemory);
	const Eigen::VectorXd load = loads(lower).col(1);
	ASSERT_TRUE(given.factorize(lower));
	EXPECT_LT(residualShare(lower, given.solve(load), load), 1e-12);
}

} // namespace
} // namespace developable::test
