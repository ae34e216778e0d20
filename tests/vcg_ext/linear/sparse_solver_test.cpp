// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/sparse_solver.h"

#include "matrices.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

constexpr double little = 1, much = 1e9; // bytes

TEST(SparseSolver, IteratesWhereMemoryWouldNotDo) {
	const SparseMatrix lower = plate();
	const Eigen::MatrixXd rightHandSide = loads(lower);
	SparseSolver exact(much);
	EXPECT_FALSE(exact.iterates());
	ASSERT_TRUE(exact.factorize(lower));
	EXPECT_FALSE(exact.iterates());
	const Eigen::MatrixXd expected = exact.solve(rightHandSide);
	SparseSolver iterative(little);
	ASSERT_TRUE(iterative.factorize(lower));
	EXPECT_TRUE(iterative.iterates());
	EXPECT_LT((iterative.solve(rightHandSide) - expected).norm(), 0.02 * expected.norm());
}

TEST(SparseSolver, FactorisesAsLongAsTheFactorFits) {
	const SparseMatrix lower = plate();
	const double needed = SparseCholesky().analyze(lower);
	SparseSolver fits(needed), doesNot(needed - 1), asTheMachineHas(0);
	for (SparseSolver* solver : {&fits, &doesNot, &asTheMachineHas})
		ASSERT_TRUE(solver->factorize(lower));
	EXPECT_FALSE(fits.iterates());
	EXPECT_TRUE(doesNot.iterates());
	EXPECT_FALSE(asTheMachineHas.iterates());
}

TEST(SparseSolver, IterationIsAsExactAsItIsAskedFor) {
	const SparseMatrix lower = plate();
	const Eigen::MatrixXd rightHandSides = loads(lower);
	const auto residual = [&](const Iteration& iteration, int column) {
		SparseSolver solver(little, iteration);
		EXPECT_TRUE(solver.factorize(lower));
		EXPECT_TRUE(solver.iterates());
		const Eigen::VectorXd rightHandSide = rightHandSides.col(column);
		return residualShare(lower, solver.solve(rightHandSide), rightHandSide);
	};
	for (const int column : {0, 1}) {
		EXPECT_LT(residual({}, column), 1.001e-3);
		EXPECT_GT(residual({}, column), 1e-9); // so it takes an option to get there
		EXPECT_LT(residual({1e-9, 2000}, column), 1.001e-9);
		EXPECT_GT(residual({1e-9, 2}, column), 1e-9); // two steps do not
	}
}

TEST(SparseSolver, SolvesWithTheLastMatrixAndAfterAMove) {
	for (const double memory : {little, much}) {
		SparseSolver first(memory, {1e-10, 2000});
		const Eigen::VectorXd rightHandSide = loads(plate(15)).col(1);
		for (const double bending : {1.0, 0.01}) {
			const SparseMatrix lower = plate(15, 1, bending);
			ASSERT_TRUE(first.factorize(lower));
			EXPECT_LT(residualShare(lower, first.solve(rightHandSide), rightHandSide), 1e-9);
		}
		const SparseSolver second = std::move(first);
		EXPECT_EQ(second.iterates(), memory == little);
		EXPECT_LT(residualShare(plate(15, 1, 0.01), second.solve(rightHandSide), rightHandSide), 1e-9);
	}
}

TEST(SparseSolver, SaysWhereThereIsNoFactorisation) {
	SparseMatrix indefinite = plate();
	indefinite.coeffRef(7, 7) = -1;
	EXPECT_FALSE(SparseSolver(much).factorize(indefinite));
}

} // namespace
} // namespace developable::test
