// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/restoration.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

TriangleMesh sphereWithoutPole() {
	const TriangleMesh ball = sphere(1, 2);
	return makeMesh(ball.positions, ball.triangles.rightCols(ball.triangleCount() - 4));
}

TEST(Restoration, ReachesTheGoalFromNearby) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, bumpedCylinder));
	Positions nearby = expectConverges(assembly, 0.01);
	nearby += 1e-3 * Positions::Random(3, assembly.placeCount());
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, nearby, 50, silent);
	detail::GaussNewton steps(problem, run, true);
	EXPECT_EQ(detail::Restoration(problem, run, steps, 1e-5 * steps.greatestResponse()).restore(),
			  detail::Ending::Reached);
	EXPECT_LE(angleDefects(assembly, run.shape().positions).cwiseAbs().sum(), 1e-4);
	EXPECT_LT((run.shape().positions - nearby).cwiseAbs().maxCoeff(), 0.02);
	expectSound(assembly, run.shape().positions);
}

TEST(Restoration, FactorisesFewerSystemsWithChords) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, steepBump));
	const auto restored = [&](int chords) {
		NewtonTuning tuning;
		tuning.slowSystem = tuning.slowStiffSystem = 1; // all but the first are factorised
		tuning.chords = chords;
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		problem.jacobian().freeBorders(true);
		const Progress silent;
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::GaussNewton steps(problem, run, true);
		EXPECT_EQ(detail::Restoration(problem, run, steps, 1e-3 * steps.greatestResponse()).restore(),
				  detail::Ending::Reached);
		expectSound(assembly, run.shape().positions);
		return run.iterations();
	};
	EXPECT_LT(restored(6), restored(1));
}

/// Angle defects among triangles that had to be made very stiff hardly respond any more.
TEST(Restoration, ReachesTheGoalWhereStiffTrianglesHoldItUp) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, bumpedCylinder));
	Positions nearby = expectConverges(assembly, 0.01);
	nearby += 2e-3 * Positions::Random(3, assembly.placeCount());
	detail::NewtonProblem problem = problemOf(assembly);
	std::vector<int> fan; // round a place whose defect only they can change
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if ((assembly.trianglePlaces.col(t).array() == 220).any())
			fan.push_back(t);
	for (int times = 0; times < 22; ++times)
		problem.metric().stiffen(fan);
	ASSERT_FALSE(problem.metric().tooStiff());
	const Progress silent;
	detail::NewtonRun run(problem, nearby, 50, silent);
	detail::GaussNewton steps(problem, run, true);
	EXPECT_EQ(detail::Restoration(problem, run, steps, 1e-5 * steps.greatestResponse()).restore(),
			  detail::Ending::Reached);
	expectSound(assembly, run.shape().positions);
}

/// With ε no less than a share of how much light places respond steps go a few hundredths of the way.
TEST(Restoration, ReachesTheGoalWhereHeavyPlacesHoldItUp) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, bumpedCylinder));
	Positions nearby = expectConverges(assembly, 0.01);
	nearby += 1e-3 * Positions::Random(3, assembly.placeCount());
	const NewtonTuning usual;
	for (const double least : {usual.restorationLeastHeldUp, usual.restorationLeast}) {
		NewtonTuning tuning;
		tuning.restorationLeastHeldUp = least;
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		const Progress silent;
		detail::NewtonRun run(problem, nearby, 200, silent);
		detail::GaussNewton steps(problem, run, true);
		const double epsilon = 1e-5 * steps.greatestResponse();
		problem.weigh(1e7 * problem.metric().placeMass());
		ASSERT_TRUE(problem.metric().factorize());
		EXPECT_EQ(detail::Restoration(problem, run, steps, epsilon).restore(),
				  least < usual.restorationLeast ? detail::Ending::Reached : detail::Ending::Stuck);
		expectSound(assembly, run.shape().positions);
	}
}

TEST(Restoration, IsStuckWhereNothingMayMove) {
	PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	assembly.placeFixed.assign(assembly.placeCount(), 1);
	assembly.placeFixed[40] = 0;
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	detail::GaussNewton steps(problem, run, false);
	EXPECT_EQ(detail::Restoration(problem, run, steps, 1e-5 * steps.greatestResponse()).restore(),
			  detail::Ending::Stuck);
	EXPECT_LT(run.iterations(), 200);
	EXPECT_LE(run.shape().curvature, run.startCurvature());
}

TEST(Restoration, EndsWhereItCrawls) {
	const PatchAssembly assembly = assembled(sphereWithoutPole());
	const auto stepsOf = [&](double slow) {
		NewtonTuning tuning;
		tuning.restorationSlow = slow;
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4}, tuning, 0);
		problem.setSmoothness(3e-6);
		problem.jacobian().freeBorders(true);
		const Progress silent;
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::GaussNewton steps(problem, run, false);
		EXPECT_EQ(detail::Restoration(problem, run, steps, 1e-5 * steps.greatestResponse()).restore(),
				  detail::Ending::Stuck);
		return run.iterations();
	};
	EXPECT_LT(stepsOf(0.5), stepsOf(1));
	EXPECT_GE(stepsOf(0.5), NewtonTuning().restorationReview);
}

} // namespace
} // namespace developable::test
