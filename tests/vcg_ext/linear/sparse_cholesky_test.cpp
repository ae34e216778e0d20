// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/sparse_cholesky.h"

#include "matrices.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace developable::test {
namespace {

TEST(SparseCholesky, SolvesAsEigensOwnFactorisationDoes) {
	const SparseMatrix lower = plate();
	SparseCholesky ours;
	ASSERT_TRUE(ours.factorize(lower));
	const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> eigens(lower);
	const Eigen::MatrixXd rightHandSide = loads(lower);
	const Eigen::MatrixXd expected = eigens.solve(rightHandSide);
	EXPECT_LT((ours.solve(rightHandSide) - expected).norm(), 1e-9 * expected.norm());
	for (const int column : {0, 1}) {
		const Eigen::VectorXd one = ours.solve(Eigen::VectorXd(rightHandSide.col(column)));
		EXPECT_LT((one - expected.col(column)).norm(), 1e-9 * expected.norm());
	}
}

TEST(SparseCholesky, KnowsWhatAFactorisationTakes) {
	constexpr int rows = 30; // of a column with k numbers k² operations
	SparseCholesky cholesky;
	cholesky.analyze(SparseMatrix(Eigen::MatrixXd::Ones(rows, rows).sparseView()));
	EXPECT_DOUBLE_EQ(cholesky.operations(), rows * (rows + 1) * (2 * rows + 1) / 6);
	SparseMatrix diagonal(rows, rows);
	diagonal.setIdentity();
	cholesky.analyze(diagonal);
	EXPECT_DOUBLE_EQ(cholesky.operations(), rows);
}

TEST(SparseCholesky, KnowsMatricesThatAreNotPositiveDefinite) {
	SparseMatrix indefinite = plate();
	indefinite.coeffRef(7, 7) = -1;
	EXPECT_FALSE(SparseCholesky().factorize(indefinite));
	EXPECT_FALSE(SparseCholesky().factorize(plate(5, -1e-3, 1))); // constants have a negative eigenvalue
	// What failed does not keep the next one of the pattern from being factorised.
	SparseCholesky cholesky;
	ASSERT_FALSE(cholesky.factorize(indefinite));
	ASSERT_TRUE(cholesky.factorize(plate()));
	const Eigen::VectorXd rightHandSide = loads(indefinite).col(1);
	EXPECT_LT(residualShare(plate(), cholesky.solve(rightHandSide), rightHandSide), 1e-10);
}

TEST(SparseCholesky, ReadsTheLowerTriangleOnly) {
	const SparseMatrix lower = plate(9);
	SparseMatrix withOther = lower + SparseMatrix(lower.transpose().triangularView<Eigen::StrictlyUpper>());
	for (int column = 1; column < withOther.cols(); ++column)
		if (withOther.coeff(column - 1, column) != 0)
			withOther.coeffRef(column - 1, column) = 1e6;
	SparseCholesky cholesky;
	ASSERT_TRUE(cholesky.factorize(withOther));
	const Eigen::VectorXd rightHandSide = loads(lower).col(1);
	EXPECT_LT(residualShare(lower, cholesky.solve(rightHandSide), rightHandSide), 1e-12);
}

TEST(SparseCholesky, FactorisesManyMatricesOfOnePattern) {
	SparseCholesky cholesky;
	const Eigen::VectorXd rightHandSide = loads(plate(15)).col(1);
	for (const double bending : {1.0, 0.01, 100.0}) {
		const SparseMatrix lower = plate(15, 1, bending);
		ASSERT_TRUE(cholesky.factorize(lower));
		EXPECT_LT(residualShare(lower, cholesky.solve(rightHandSide), rightHandSide), 1e-12);
	}
	SparseCholesky moved = std::move(cholesky);
	EXPECT_LT(residualShare(plate(15, 1, 100), moved.solve(rightHandSide), rightHandSide), 1e-12);
}

TEST(SparseCholesky, FindsTheSameOrderOnManyThreadsAtOnce) {
	const SparseMatrix lower = plate(61);
	const Eigen::VectorXd rightHandSide = loads(lower).col(1);
	const auto solution = [&] {
		SparseCholesky cholesky;
		return cholesky.factorize(lower) ? cholesky.solve(rightHandSide) : Eigen::VectorXd();
	};
	const Eigen::VectorXd alone = solution();
	std::vector<Eigen::VectorXd> solutions(8);
	std::vector<std::thread> threads;
	for (Eigen::VectorXd& one : solutions)
		threads.emplace_back([&] { one = solution(); });
	for (std::thread& thread : threads)
		thread.join();
	for (const Eigen::VectorXd& one : solutions)
		EXPECT_EQ(one, alone);
}

TEST(SparseCholesky, EstimatesTheMemoryOfTheFactor) {
	// Diagonal: one number a row. A plate's factor is denser than the matrix, and more so the larger it is.
	SparseMatrix diagonal(1000, 1000);
	diagonal.setIdentity();
	EXPECT_LE(SparseCholesky().analyze(diagonal), 12 * 1000);
	double before = 0;
	for (const int side : {10, 20, 40}) {
		const SparseMatrix lower = plate(side);
		const double perRow = SparseCholesky().analyze(lower) / static_cast<double>(lower.rows());
		EXPECT_GT(perRow, 8.0 * static_cast<double>(lower.nonZeros()) / static_cast<double>(lower.rows()));
		EXPECT_LT(perRow, 12.0 * static_cast<double>(lower.rows())); // a full triangle takes half of it
		EXPECT_GT(perRow, before);
		before = perRow;
	}
}

} // namespace
} // namespace developable::test
