// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that are sewn together come closer than the preferred displacement where few places need it.
#include "developable/newton/closer_shapes.h"

#include "developable/newton/displacement_metric.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

Positions solved(const PatchAssembly& assembly, int rounds) {
	ConstrainedNewtonOptions options;
	options.tuning.closerRounds = rounds;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
	return positions;
}

double leastFarthest(const PatchAssembly& assembly) {
	const NewtonTuning tuning;
	return tuning.closerFrom * tuning.preferredMove * boxDiagonal(assembly.originalPositions);
}

/// On one level, and on a finer one beside which a coarse one is brought closer, too.
TEST(CloserShapes, haveNearerFarthestPlacesAndOthersHardlyFarther) {
	for (const int side : {25, 41})
		for (const auto& [surface, height] : {std::make_pair(Surface(saddle), 1.0), {Surface(wave), 1.5}}) {
			const PatchAssembly assembly = mirroredPatches(side, surface, height);
			const Positions before = solved(assembly, 0), closer = solved(assembly, 8);
			EXPECT_LT(farthestMove(assembly, closer), 0.9 * farthestMove(assembly, before));
			EXPECT_LT(farthestMove(assembly, closer) * meanDisplacement(assembly, closer),
					  farthestMove(assembly, before) * meanDisplacement(assembly, before));
			EXPECT_GE(farthestMove(assembly, closer), 0.9 * leastFarthest(assembly));
			expectSound(assembly, closer);
			EXPECT_EQ(closer, solved(assembly, 8));
		}
}

/// Every round is tried from what the rounds before came to, and ends by about closerStep nearer or is the
/// last.
TEST(CloserShapes, areFoundInRounds) {
	const PatchAssembly assembly = mirroredPatches(25, saddle, 1.0);
	double before = farthestMove(assembly, solved(assembly, 0));
	for (int rounds = 1; rounds <= 4; ++rounds) {
		const double after = farthestMove(assembly, solved(assembly, rounds));
		EXPECT_LE(after, NewtonTuning().closerStep * before) << rounds;
		before = after;
	}
}

TEST(CloserShapes, areNotLookedForOfASinglePanelNorOfWhatIsNear) {
	const PatchAssembly single = assembled(jitteredGrid(25, 25, bumpedCylinder));
	EXPECT_GT(farthestMove(single, solved(single, 0)), leastFarthest(single));
	EXPECT_EQ(solved(single, 0), solved(single, 8));
	const PatchAssembly near = mirroredPatches(25, saddle, 0.1);
	EXPECT_EQ(solved(near, 0), solved(near, 8));
}

TEST(CloserShapes, areGivenUpWhenOneStops) {
	expectStopsAt("closer: ", sewnPatches(25), {});
}

} // namespace
} // namespace developable::test
