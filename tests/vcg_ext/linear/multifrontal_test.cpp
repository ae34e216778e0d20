// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/multifrontal.h"

#include "developable/mesh/mesh.h"
#include "matrices.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// Several matrices along the diagonal of one.
SparseMatrix sideBySide(const std::vector<SparseMatrix>& matrices) {
	std::vector<Eigen::Triplet<double>> entries;
	int rows = 0;
	for (const SparseMatrix& matrix : matrices) {
		for (int column = 0; column < matrix.outerSize(); ++column)
			for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
				entries.emplace_back(rows + entry.row(), rows + column, entry.value());
		rows += static_cast<int>(matrix.rows());
	}
	SparseMatrix result(rows, rows);
	result.setFromTriplets(entries.begin(), entries.end());
	return result;
}

SparseMatrix diagonal(int rows, double value) {
	SparseMatrix result(rows, rows);
	result.setIdentity();
	return value * result;
}

Eigen::MatrixXd solutions(const SparseMatrix& lower, int threads) {
	const ThreadShare share(threads);
	SparseCholesky cholesky;
	EXPECT_TRUE(cholesky.factorize(lower));
	return cholesky.solve(loads(lower));
}

TEST(Multifrontal, HasTheSameBitsOnAnyNumberOfThreads) {
	const SparseMatrix lower = plate(150);
	const Eigen::MatrixXd alone = solutions(lower, 1);
	for (const int threads : {2, 3, 8})
		EXPECT_TRUE(solutions(lower, threads) == alone) << threads;
}

TEST(Multifrontal, SolvesMatricesOfManyParts) {
	// Trees of one supernode and of many; large ones have threads of their own.
	const SparseMatrix lower =
		sideBySide({diagonal(3, 2), plate(5), plate(90), diagonal(500, 0.5), plate(60)});
	const Eigen::MatrixXd solved = solutions(lower, 2), rightHandSides = loads(lower);
	for (const int column : {0, 1})
		EXPECT_LT(residualShare(lower, solved.col(column), rightHandSides.col(column)), 1e-10);
	EXPECT_TRUE(solutions(lower, 1) == solved);
}

TEST(Multifrontal, KnowsWhichPartsAreNotPositiveDefinite) {
	const SparseMatrix good = plate(80);
	for (const int row : {0, 3000, 6399}) {
		SparseMatrix bad = good;
		bad.coeffRef(row, row) = -1;
		const ThreadShare share(2);
		EXPECT_FALSE(SparseCholesky().factorize(bad)) << row;
		EXPECT_FALSE(SparseCholesky().factorize(sideBySide({good, bad, good}))) << row;
	}
}

TEST(Multifrontal, TakesMatricesWithRoomBetweenTheirNumbers) {
	const SparseMatrix lower = plate(40);
	SparseMatrix roomy = lower;
	roomy.uncompress();
	ASSERT_FALSE(roomy.isCompressed());
	EXPECT_TRUE(solutions(roomy, 1) == solutions(lower, 1));
}

} // namespace
} // namespace developable::test
