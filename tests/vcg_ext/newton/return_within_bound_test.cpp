// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/return_within_bound.h"

#include "developable/newton/continuation.h"
#include "developable/newton/pull_back.h"
#include "developable/newton/restoration.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// A developable shape near a steep bump, with places far away, and what goes on from it.
struct FarAway {
	FarAway(const PatchAssembly& bump, double share, const NewtonTuning& tuning = {})
		: assembly(bump), problem(problemOf(bump, tuning)), run(problem, bump.originalPositions, 200, silent),
		  steps(problem, run, false) {
		goThere();
		bound = share * run.shape().farthest;
	}

	void goThere() {
		detail::Continuation continuation(problem, run, steps);
		continuation.follow();
		detail::Restoration(problem, run, steps, continuation.epsilon()).restore();
	}

	const PatchAssembly& assembly;
	const Progress silent;
	detail::NewtonProblem problem;
	detail::NewtonRun run;
	detail::GaussNewton steps;
	double bound = 0; ///< length
};

TEST(ReturnWithinBound, ReachesADevelopableShapeThatIsNearer) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, steepBump));
	for (const double share : {0.95, 0.85, 0.7}) {
		FarAway far(assembly, share);
		ASSERT_TRUE(far.run.shape().reached);
		detail::ReturnWithinBound way(far.problem, far.run, far.steps, far.bound);
		ASSERT_EQ(way.run(), detail::Ending::Reached) << share;
		EXPECT_LE(far.run.shape().farthest, far.bound);
		EXPECT_EQ(way.found().farthest, far.run.shape().farthest);
		EXPECT_LE(angleDefects(assembly, far.run.shape().positions).cwiseAbs().sum(), 1e-4);
		expectSound(assembly, far.run.shape().positions);
	}
}

TEST(ReturnWithinBound, SaysHowNearItCameWhereTheBoundIsOutOfReach) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, steepBump));
	FarAway far(assembly, 0.4);
	const double before = far.run.shape().farthest;
	detail::ReturnWithinBound way(far.problem, far.run, far.steps, far.bound);
	EXPECT_EQ(way.run(), detail::Ending::Stuck);
	EXPECT_LT(way.found().farthest, before);
	EXPECT_EQ(far.run.shape().positions, way.found().positions);
	EXPECT_TRUE(far.run.shape().reached);
	EXPECT_GT(way.found().farthest, far.bound);
}

TEST(ReturnWithinBound, DoesNotBeginFromMuchTooFar) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, steepBump));
	FarAway far(assembly, 0.1);
	const detail::Shape before = far.run.shape();
	const int steps = far.run.iterations();
	EXPECT_EQ(detail::ReturnWithinBound(far.problem, far.run, far.steps, far.bound).run(),
			  detail::Ending::Stuck);
	EXPECT_EQ(far.run.iterations(), steps);
	EXPECT_EQ(far.run.shape().positions, before.positions);
}

/// Preferred is such a share of how far a developable shape moves a place.
NewtonTuning preferring(const PatchAssembly& assembly, double share) {
	FarAway far(assembly, share);
	NewtonTuning tuning;
	tuning.preferredMove = far.bound / far.problem.diagonal();
	tuning.preferredPrice = 2;
	return tuning;
}

TEST(ReturnWithinBound, IsNotTriedForWhatIsPreferredWhereMuchCurvatureWouldComeBack) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, wave));
	for (const double share : {0.95, 0.5}) {
		FarAway far(assembly, share, preferring(assembly, share));
		const detail::Shape before = far.run.shape();
		const int steps = far.run.iterations();
		EXPECT_EQ(mayBePreferred(far.problem, before), share > 0.9) << share;
		EXPECT_EQ(withinPreferred(far.problem, far.run, far.steps), detail::Ending::Reached);
		if (share > 0.9) {
			EXPECT_LE(far.run.shape().farthest, far.problem.preferredMove());
			continue;
		}
		EXPECT_EQ(far.run.iterations(), steps);
		EXPECT_EQ(far.run.shape().positions, before.positions);
	}
}

TEST(ReturnWithinBound, EndsForWhatIsPreferredWhenItHasTakenSoManyTimesTheRest) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, steepBump));
	NewtonTuning tuning = preferring(assembly, 0.85);
	tuning.preferredCurvature = 1;
	tuning.pullBackReach = 1; // rounds only
	for (const double times : {0.01, 100.0}) {
		tuning.preferredWork = times;
		FarAway far(assembly, 0.85, tuning);
		const detail::Shape before = far.run.shape();
		EXPECT_EQ(withinPreferred(far.problem, far.run, far.steps), detail::Ending::Reached);
		EXPECT_EQ(far.run.shape().farthest <= far.problem.preferredMove(), times > 1) << times;
		EXPECT_EQ(far.run.shape().positions == before.positions, times < 1) << times;
		EXPECT_TRUE(far.run.shape().reached);
	}
}

TEST(ReturnWithinBound, IsLeftToOtherWaysWhereTheyFollowAndPlacesArePulledBackFromNearlyThere) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, wave));
	for (const double share : {0.95, 0.85}) {
		const NewtonTuning tuning = preferring(assembly, share);
		FarAway back(assembly, share, tuning), left(assembly, share, tuning.beforeOthers());
		const Positions before = left.run.shape().positions;
		for (FarAway* far : {&back, &left})
			EXPECT_EQ(withinPreferred(far->problem, far->run, far->steps), detail::Ending::Reached);
		EXPECT_LE(back.run.shape().farthest, back.problem.preferredMove()) << share;
		EXPECT_EQ(left.run.shape().positions == before, share < 0.9) << share;
		EXPECT_EQ(left.run.shape().farthest <= left.problem.preferredMove(), share > 0.9) << share;
	}
}

} // namespace
} // namespace developable::test
