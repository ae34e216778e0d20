// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that are sewn together and were led astray by one coarse level get there by another.
#include "developable/newton/other_levels.h"

#include "developable/newton/displacement_metric.h"
#include "support/newton_checks.h"
#include "threads_allowed.h"

namespace developable::test {
namespace {

/// The weight of places at the bound stays what it is, and finer levels are as smooth as the coarsest: else
/// the usual way ends near in more cases.
ConstrainedNewtonOptions optionsWith(int otherLevels) {
	ConstrainedNewtonOptions options;
	options.tuning.closerRounds = 0;
	options.tuning.boundWeightIncrease = 1;
	options.tuning.fineSmoothness = 1;
	options.tuning.otherLevels = otherLevels;
	return options;
}

Positions solved(const PatchAssembly& assembly, int otherLevels = NewtonTuning().otherLevels) {
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, optionsWith(otherLevels)).status, Status::Converged);
	return positions;
}

/// Share of how far a place had better move.
double farthestShare(const PatchAssembly& assembly, const Positions& positions) {
	return farthestMove(assembly, positions) /
		   (NewtonTuning().preferredMove * boxDiagonal(assembly.originalPositions));
}

/// The first is solved from a coarser level, the others directly.
TEST(OtherLevels, LeadToAShapeThatIsNearWhereTheUsualOneEndsFarAway) {
	for (const PatchAssembly& assembly : {mirroredPatches(54, saddle, 1.5), mirroredPatches(29, saddle, 2),
										  mirroredPatches(26, largeSaddle, 0.7)}) {
		EXPECT_GT(farthestShare(assembly, solved(assembly, 0)), 1.2);
		const Positions positions = solved(assembly);
		EXPECT_LE(farthestShare(assembly, positions), 1);
		EXPECT_EQ(positions, solved(assembly));
		expectSound(assembly, positions);
	}
}

TEST(OtherLevels, LeadNoFartherWhereNoneIsNearEnough) {
	for (const PatchAssembly& assembly : {mirroredPatches(28, vamp, 1.5), mirroredPatches(28, largeSaddle)}) {
		const double before = farthestShare(assembly, solved(assembly, 0));
		const Positions positions = solved(assembly);
		EXPECT_GT(before, 1);
		EXPECT_LE(farthestShare(assembly, positions), before);
		expectSound(assembly, positions);
	}
}

TEST(OtherLevels, AreSparedWhereTheUsualOneIsNearEnough) {
	const PatchAssembly assembly = mirroredPatches(50, wave, 0.7);
	const Positions usual = solved(assembly, 0);
	EXPECT_LE(farthestShare(assembly, usual), 1);
	EXPECT_EQ(solved(assembly), usual);
}

/// Others begin beside the usual one, or beside each other; those that were not needed are abandoned.
TEST(OtherLevels, EndTheSameWhenTheyBeginBesideOthers) {
	for (const PatchAssembly& assembly :
		 {mirroredPatches(29, saddle, 2), mirroredPatches(28, vamp, 1.5), mirroredPatches(36, wave, 0.7)}) {
		const auto solvedOn = [&](const char* threads, double workBeforeOthers) {
			const ThreadsAllowed allowed(threads);
			ConstrainedNewtonOptions options = optionsWith(NewtonTuning().otherLevels);
			options.tuning.workBeforeOthers = workBeforeOthers;
			Positions positions = assembly.originalPositions;
			const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, options);
			return std::make_tuple(positions, report.status, report.iterations, report.work);
		};
		const auto alone = solvedOn("1", 0);
		EXPECT_EQ(solvedOn("2", 0), alone);
		EXPECT_EQ(solvedOn("4", 1e300), alone);
	}
}

/// A single panel goes one way only; so does what is small, large or held.
TEST(OtherLevels, AreOfSewnPanelsThatAreFreeAndOfAMiddlingSize) {
	const NewtonTuning tuning;
	NewtonTuning off;
	off.otherLevels = 0;
	PatchAssembly sewn = mirroredPatches(50, saddle);
	EXPECT_TRUE(detail::mayTryOtherLevels(sewn, tuning));
	EXPECT_FALSE(detail::mayTryOtherLevels(sewn, off));
	EXPECT_FALSE(detail::mayTryOtherLevels(mirroredPatches(20, saddle), tuning));
	EXPECT_FALSE(detail::mayTryOtherLevels(mirroredPatches(70, saddle), tuning));
	EXPECT_FALSE(detail::mayTryOtherLevels(assembled(jitteredGrid(70, 70, saddle)), tuning));
	sewn.placeFixed.front() = 1;
	EXPECT_FALSE(detail::mayTryOtherLevels(sewn, tuning));
}

TEST(OtherLevels, StopWhenTheyAreTold) {
	expectStopsAt("another way: ", mirroredPatches(28, saddle, 2), optionsWith(1));
}

} // namespace
} // namespace developable::test
