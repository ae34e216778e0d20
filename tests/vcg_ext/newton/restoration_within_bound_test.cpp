// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/restoration_within_bound.h"

#include "developable/newton/displacement_metric.h"
#include "developable/newton/restoration.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// From near a developable shape, within a bound that its farthest places touch.
struct Touching {
	explicit Touching(const PatchAssembly& given) : assembly(given) {
		const Positions developable = expectConverges(given, 0.2);
		start = given.originalPositions + 0.97 * (developable - given.originalPositions);
		bound = farthestMove(given, start);
	}

	/// \param restore  of a problem, its run and its steps
	template <class Restore>
	Positions restored(const Restore& restore, const NewtonTuning& tuning = {}) const {
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		problem.jacobian().freeBorders(true);
		const Eigen::VectorXd weight = problem.metric().weight();
		const Progress silent;
		detail::NewtonRun run(problem, start, 200, silent);
		detail::GaussNewton steps(problem, run, true);
		EXPECT_EQ(restore(problem, run, steps), detail::Ending::Reached);
		EXPECT_LE((problem.metric().weight() - weight).cwiseAbs().maxCoeff(), 1e-9 * weight.maxCoeff());
		EXPECT_LE(angleDefects(assembly, run.shape().positions).cwiseAbs().sum(), 1e-4);
		expectSound(assembly, run.shape().positions);
		return run.shape().positions;
	}

	const PatchAssembly& assembly;
	Positions start;
	double bound = 0; ///< length
};

TEST(RestorationWithinBound, KeepsABoundThatOthersCrossOrComesNearer) {
	for (const Surface& surface : {Surface(steepBump), Surface(wave), Surface(largeSaddle)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(25, 25, surface));
		const Touching touching(assembly);
		const Positions within = touching.restored([&](auto& problem, auto& run, auto& steps) {
			return detail::restoreWithin(problem, run, steps, touching.bound);
		});
		const Positions free = touching.restored([&](auto& problem, auto& run, auto& steps) {
			const double epsilon = problem.tuning().returnRestoration * steps.greatestResponse();
			return detail::Restoration(problem, run, steps, epsilon).restore();
		});
		ASSERT_GT(farthestMove(assembly, free), touching.bound);
		EXPECT_LT(farthestMove(assembly, within) - touching.bound,
				  0.5 * (farthestMove(assembly, free) - touching.bound));
	}
}

TEST(RestorationWithinBound, LeadsADevelopableShapeNearerAndNeverFarther) {
	const PatchAssembly assembly = assembled(jitteredGrid(25, 25, steepBump));
	Touching far(assembly);
	far.start = expectConverges(assembly, 0.2);
	const double farthest = farthestMove(assembly, far.start);
	for (const double share : {0.97, 0.5, 1e-3}) {
		const Positions nearer = far.restored([&](auto& problem, auto& run, auto& steps) {
			return detail::restoreWithin(problem, run, steps, share * farthest);
		});
		EXPECT_LE(farthestMove(assembly, nearer), farthest);
		if (share > 0.9) {
			EXPECT_LT(farthestMove(assembly, nearer), farthest);
		}
	}
}

/// With the same weight in every round what is left beyond the bound becomes less ever more slowly.
TEST(RestorationWithinBound, EndsNearerWhereTheWeightBecomesMore) {
	const PatchAssembly assembly = assembled(jitteredGrid(33, 33, wave));
	Touching far(assembly);
	far.start = expectConverges(assembly, 0.2);
	const double bound = 0.6 * farthestMove(assembly, far.start);
	const auto farthestWith = [&](double increase) {
		NewtonTuning tuning;
		tuning.boundWeightIncrease = increase;
		const auto restore = [&](auto& problem, auto& run, auto& steps) {
			return detail::restoreWithin(problem, run, steps, bound);
		};
		return farthestMove(assembly, far.restored(restore, tuning));
	};
	EXPECT_LE(farthestWith(NewtonTuning().boundWeightIncrease), bound);
	EXPECT_GT(farthestWith(1), 1.02 * bound);
}

} // namespace
} // namespace developable::test
