// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/direct_system.h"
#include "developable/newton/multiplier_solver.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// With some places held still.
PatchAssembly heldSaddle() {
	TriangleMesh mesh = jitteredGrid(9, 9, saddle);
	mesh.vertexSelected[3] = mesh.vertexSelected[40] = 1;
	PatchOptions options;
	options.fixSelected = true;
	return assembled(mesh, options);
}

TEST(DirectSystem, SolvesWhatConjugateGradientsDo) {
	const PatchAssembly assembly = heldSaddle();
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().linearize(assembly.originalPositions);
	ASSERT_TRUE(problem.metric().factorize());
	detail::MultiplierSolver solver(problem, 100);
	const Eigen::VectorXd b = problem.shapeAt(assembly.originalPositions).scaledDefects;
	const double greatest = solver.findGreatestResponse(b);
	for (const double share : {1.0, 1e-2, 1e-5}) {
		const double epsilon = share * greatest;
		detail::DirectSystem direct(0);
		Positions response;
		ASSERT_TRUE(direct.solve(problem.metric().matrix(), problem.jacobian(), b, epsilon, response));
		// The multipliers follow from the system itself: y = (b − J x) / ε, and x = W⁻¹ Jᵀ y.
		const Eigen::VectorXd y = (b - problem.jacobian().apply(response)) / epsilon;
		const Positions expected = problem.metric().solve(problem.jacobian().applyTransposed(y));
		EXPECT_LT((response - expected).norm(), 1e-6 * expected.norm()) << share;
		EXPECT_LT((solver.apply(y) + epsilon * y - b).norm(), 1e-6 * b.norm()) << share;
		EXPECT_EQ(response.col(assembly.placeOfVertex[40]).norm(), 0);
		Positions again;
		ASSERT_TRUE(direct.solve(problem.metric().matrix(), problem.jacobian(), b, epsilon, again));
		EXPECT_EQ(again, response);
	}
}

TEST(DirectSystem, HasTheDerivativeAsAMatrix) {
	const PatchAssembly assembly = heldSaddle();
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().linearize(assembly.originalPositions);
	const Positions move = Positions::Random(3, assembly.placeCount());
	const Eigen::VectorXd change = problem.jacobian().matrix() * move.reshaped();
	EXPECT_LT((change - problem.jacobian().apply(move)).norm(), 1e-12 * change.norm());
}

TEST(DirectSystem, TakesForeseenRowsInWithoutAnotherFactorisation) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().freeBorders(false);
	problem.jacobian().linearize(assembly.originalPositions);
	const Eigen::VectorXd b = Eigen::VectorXd::Random(problem.jacobian().rowCount());
	detail::DirectSystem direct(0);
	Positions before, response, expected;
	ASSERT_TRUE(direct.solve(problem.metric().matrix(), problem.jacobian(), b, 1e-3, before));
	const Positions end = assembly.originalPositions + 0.05 * Positions::Random(3, assembly.placeCount());
	ASSERT_TRUE(problem.jacobian().foresee(assembly.originalPositions, end));
	ASSERT_TRUE(direct.solveForeseen(problem.metric().matrix(), problem.jacobian(), b, 1e-3, response));
	ASSERT_TRUE(
		detail::DirectSystem(0).solve(problem.metric().matrix(), problem.jacobian(), b, 1e-3, expected));
	EXPECT_LT((response - expected).norm(), 1e-5 * expected.norm()); // much of A⁻¹f is taken away
	EXPECT_GT((response - before).norm(), 1e-3 * expected.norm());
}

TEST(DirectSystem, SaysThatMemoryWouldNotDo) {
	const PatchAssembly assembly = heldSaddle();
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().linearize(assembly.originalPositions);
	const Eigen::VectorXd b = problem.shapeAt(assembly.originalPositions).scaledDefects;
	Positions response;
	EXPECT_FALSE(
		detail::DirectSystem(1).solve(problem.metric().matrix(), problem.jacobian(), b, 1, response));
}

TEST(DirectSystem, TakesOverWhereConjugateGradientsAreSlow) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	NewtonTuning tuning;
	Positions responses[2];
	for (const bool factorizes : {false, true}) {
		tuning.systemResidual = 1e-10;
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4}, tuning, 0);
		problem.setSmoothness(3e-6);
		problem.jacobian().linearize(assembly.originalPositions);
		ASSERT_TRUE(problem.metric().factorize());
		detail::MultiplierSolver solver(problem, factorizes ? 0 : 1000);
		const Eigen::VectorXd b = problem.shapeAt(assembly.originalPositions).scaledDefects;
		const double epsilon = 1e-4 * solver.findGreatestResponse(b);
		Eigen::VectorXd y = Eigen::VectorXd::Zero(b.size());
		for (int i = 0; i < 2; ++i) // the second time it knows
			ASSERT_TRUE(solver.solve(
				b, epsilon, y, [] { return true; }, responses[factorizes]));
		EXPECT_FALSE(solver.solve(
			-b, epsilon, y, [] { return false; }, responses[factorizes]));
	}
	EXPECT_LT((responses[0] - responses[1]).norm(), 1e-6 * responses[0].norm());
	EXPECT_NE(responses[0], responses[1]);
}

} // namespace
} // namespace developable::test
