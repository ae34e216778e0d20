// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/fine_level.h"

#include "developable/newton/coarsening.h"
#include "developable/newton/displacement_metric.h"
#include "developable/newton/prolongation.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// A wave with ripples that are shorter than the edges of a coarse level, and what that level comes to.
struct Rippled {
	explicit Rippled(double height, const NewtonTuning& tuning = {})
		: fine(assembled(jitteredGrid(41, 41,
									  [=](double u, double v) -> Eigen::Vector3d {
										  const double ripple = std::sin(60 * u) * std::sin(60 * v);
										  return wave(u, v) + Eigen::Vector3d(0, 0, height * ripple);
									  }))),
		  problem(problemOf(fine, tuning)) {
		const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(300);
		const Positions solved = expectConverges(coarse.assembly, 0.2);
		detail::BendingMatrix bending(fine);
		const detail::Prolongation prolongation(fine, coarse, bending, {});
		shape = {true, farthestMove(coarse.assembly, solved),
				 prolongation.of(solved - coarse.assembly.originalPositions),
				 prolongation.smoothing(fine.originalPositions)};
		problem.jacobian().freeBorders(true);
		problem.budget().spend(1000 * fine.placeCount()); // on the coarse level
	}

	detail::NewtonOutcome solve(int maxIterations = 200) {
		return detail::solveFine(problem, shape, maxIterations, {});
	}

	const PatchAssembly fine;
	detail::NewtonProblem problem;
	detail::CoarseShape shape;
};

TEST(FineLevel, FollowsADevelopableCoarseShapeWithinThePreferredMove) {
	for (const double height : {0.0, 0.005}) {
		Rippled rippled(height);
		ASSERT_LE(rippled.shape.farthest, rippled.problem.preferredMove());
		const detail::NewtonOutcome outcome = rippled.solve();
		EXPECT_EQ(outcome.ending, detail::Ending::Reached);
		EXPECT_LE(angleDefects(rippled.fine, outcome.positions).cwiseAbs().sum(), 1e-4);
		EXPECT_LE(farthestMove(rippled.fine, outcome.positions), rippled.problem.preferredMove());
		expectSound(rippled.fine, outcome.positions);
	}
}

TEST(FineLevel, BeginsAtASmoothedSurfaceWhereThatLeavesLessCurvature) {
	NewtonTuning tuning;
	tuning.beyondPreferred = 0; // or it would begin once more, elsewhere
	Rippled smoothed(0.005, tuning), whole(0.005, tuning);
	whole.shape.smoothing.setZero();
	const auto curvatureAtFirst = [](Rippled& rippled) {
		return angleDefects(rippled.fine, rippled.solve(0).positions).cwiseAbs().sum();
	};
	EXPECT_LT(curvatureAtFirst(smoothed), 0.7 * curvatureAtFirst(whole));
}

TEST(FineLevel, TakesNoMoreStepsThanItMay) {
	Rippled rippled(0.005);
	const detail::NewtonOutcome outcome = rippled.solve(2);
	EXPECT_EQ(outcome.iterations, 2);
	EXPECT_NE(outcome.ending, detail::Ending::Reached);
}

TEST(FineLevel, BeginsFromTheBestThatACoarseLevelWithoutASolutionCameTo) {
	Rippled rippled(0);
	rippled.shape.developable = false;
	rippled.shape.displacement *= 0.5;
	const detail::NewtonOutcome outcome = rippled.solve();
	EXPECT_LT(angleDefects(rippled.fine, outcome.positions).cwiseAbs().sum(),
			  angleDefects(rippled.fine, rippled.fine.originalPositions).cwiseAbs().sum());
}

} // namespace
} // namespace developable::test
