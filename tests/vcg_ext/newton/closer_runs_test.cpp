// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that are sewn together come closer than the preferred displacement where few places need it.
#include "developable/newton/closer_runs.h"

#include "developable/newton/displacement_metric.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

Positions solved(const PatchAssembly& assembly, int tries) {
	ConstrainedNewtonOptions options;
	options.tuning.closerTries = tries;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
	return positions;
}

TEST(CloserRuns, bringTheFarthestPlacesNearerAndOthersHardlyFarther) {
	for (const auto& [surface, height] : {std::make_pair(Surface(saddle), 1.0), {Surface(wave), 1.5}}) {
		const PatchAssembly assembly = mirroredPatches(25, surface, height);
		const Positions before = solved(assembly, 0), closer = solved(assembly, 3);
		EXPECT_LT(farthestMove(assembly, closer), 0.8 * farthestMove(assembly, before));
		EXPECT_LT(meanDisplacement(assembly, closer), 1.05 * meanDisplacement(assembly, before));
		expectSound(assembly, closer);
		EXPECT_EQ(closer, solved(assembly, 3));
	}
}

/// Where many places are far away there is nothing to be tried, nor with a single panel.
TEST(CloserRuns, areSparedWhereTheyWouldHardlyLeadCloser) {
	for (const PatchAssembly& assembly :
		 {mirroredPatches(25, largeSaddle), assembled(jitteredGrid(25, 25, bumpedCylinder))})
		EXPECT_EQ(solved(assembly, 0), solved(assembly, 3));
	const PatchAssembly near = mirroredPatches(25, saddle, 0.1);
	EXPECT_EQ(solved(near, 0), solved(near, 3));
}

TEST(CloserRuns, stopWhenTheyAreTold) {
	const PatchAssembly assembly = sewnPatches(25);
	Positions positions = assembly.originalPositions;
	bool begun = false;
	const ConstrainedNewtonReport report =
		constrainedNewton(assembly, positions, {}, [&](double, const std::string& message) {
			begun = begun || message.find("closer: ") != std::string::npos;
			return !begun;
		});
	EXPECT_TRUE(begun);
	EXPECT_EQ(report.status, Status::Stopped);
}

TEST(CloserRuns, haveTheSameBoundsWhateverIsPreferred) {
	const PatchAssembly assembly = sewnPatches(25);
	NewtonTuning tuning;
	tuning.closerStep = 0.5;
	const double first = tuning.preferredMove * boxDiagonal(assembly.originalPositions);
	EXPECT_DOUBLE_EQ(detail::boundWithin(assembly, tuning), first);
	for (const auto& [length, bound] : {std::make_pair(1.0, 1.0), {0.99, 0.5}, {0.5, 0.5}, {0.13, 0.125}}) {
		tuning.preferredLength = length * first;
		EXPECT_DOUBLE_EQ(detail::boundWithin(assembly, tuning), bound * first);
	}
}

} // namespace
} // namespace developable::test
