// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/pull_back.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// |g|² that is left within a bound, a share of the diagonal, below what would do.
double squaredDefectsLeft(const PatchAssembly& assembly, double bound, int rounds) {
	const Progress silent;
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().freeBorders(true);
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	const detail::Ending ending = detail::stepsWithin(problem, run, bound * problem.diagonal(), rounds);
	EXPECT_EQ(ending, detail::Ending::Stuck);
	EXPECT_LE(run.shape().farthest, bound * problem.diagonal());
	return run.shape().squaredDefects();
}

TEST(StepsWithin, LeaveNoMoreForFurtherRounds) {
	double gained = 0;
	for (const Surface& surface : {Surface(sphereCap(1)), Surface(bumpedCylinder)})
		for (const int columns : {11, 15}) {
			const PatchAssembly assembly = assembled(jitteredGrid(columns, columns, surface));
			const double one = squaredDefectsLeft(assembly, 0.02, 1);
			const double two = squaredDefectsLeft(assembly, 0.02, 2);
			EXPECT_LE(two, one);
			gained = std::max(gained, 1 - two / one);
		}
	EXPECT_GT(gained, 0); // else they were never worth their while
}

} // namespace
} // namespace developable::test
