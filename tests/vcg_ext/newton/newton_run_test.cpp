// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/newton_run.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// |x - target|² of all places.
detail::NewtonRun::Merit distanceTo(const Positions& target) {
	return [&target](const detail::Shape& shape) { return (shape.positions - target).squaredNorm(); };
}

TEST(NewtonRun, GoesAllTheWayWhereTheShapeStaysSound) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	const detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 5, silent);
	const Positions target = 1.01 * assembly.originalPositions;
	const Positions direction = target - assembly.originalPositions;
	EXPECT_EQ(run.descend(direction, distanceTo(target), -2 * direction.squaredNorm(), 3), 1);
	EXPECT_LT((run.shape().positions - target).norm(), 1e-14);
	EXPECT_NEAR(run.shape().curvature, run.startCurvature(), 1e-9); // of a scaled shape
}

TEST(NewtonRun, GoesHalfTheWayAndSoOnWhereThatIsLower) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	const detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 5, silent);
	const Positions target = 1.01 * assembly.originalPositions;
	const Positions tooFar = 5 * (target - assembly.originalPositions);
	const double slope = -2 * tooFar.cwiseProduct(target - assembly.originalPositions).sum();
	EXPECT_EQ(run.descend(tooFar, distanceTo(target), slope, 3), 0.25);
	EXPECT_EQ(run.descend(-tooFar, distanceTo(target), -1, 3), 0); // up, whatever the slope says
	EXPECT_LT((run.shape().positions - assembly.originalPositions - tooFar / 4).norm(), 1e-14);
}

TEST(NewtonRun, SparesTrianglesAndKeepsWithinItsBound) {
	const PatchAssembly assembly = assembled(grid(5, 5, flatSheet));
	const detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 5, silent);
	Positions target = assembly.originalPositions;
	target(0, 12) += 0.4; // beyond its neighbour
	const Positions direction = target - assembly.originalPositions;
	const detail::NewtonRun::Merit merit = [&](const detail::Shape& shape) {
		return -shape.positions(0, 12);
	};
	EXPECT_GT(run.descend(direction, merit, -0.4, 6), 0);
	EXPECT_TRUE(problem.soundness().holds(run.shape().positions));
	detail::NewtonRun bounded(problem, assembly.originalPositions, 5, silent);
	EXPECT_EQ(bounded.descend(direction, merit, -1e-3, 6, 1e-3), 1);
	EXPECT_LE(bounded.shape().farthest, 1e-3);
	EXPECT_GT(bounded.shape().farthest, 0.999e-3);
}

TEST(NewtonRun, KeepsTheLastShapeThatWasNear) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	const double diagonal = boxDiagonal(assembly.originalPositions);
	const detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.2 * diagonal}, {}, 0);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 5, silent);
	const detail::NewtonRun::Merit farther = [](const detail::Shape& shape) { return -shape.farthest; };
	Positions along = Positions::Zero(3, assembly.placeCount());
	along.row(2).setConstant(0.15 * diagonal);
	ASSERT_EQ(run.descend(along, farther, -1e-9, 0), 1);
	const Positions near = run.shape().positions;
	ASSERT_EQ(run.descend(along, farther, -1e-9, 0), 1);
	EXPECT_EQ(run.nearest(), near);
	EXPECT_FALSE(run.farOff()); // it is far, but not developable
}

TEST(NewtonRun, TakesNoMoreStepsThanItMay) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	const detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 2, silent);
	EXPECT_TRUE(run.takeStep());
	EXPECT_TRUE(run.takeStep());
	EXPECT_FALSE(run.takeStep());
	EXPECT_EQ(run.iterations(), 2);
}

} // namespace
} // namespace developable::test
