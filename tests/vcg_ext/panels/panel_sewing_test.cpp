// SPDX-License-Identifier: GPL-3.0-or-later
// Plans are sewn once, and once more when they have changed.
#include "developable/panels/panel_sewing.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::GivenPatches;
using detail::PanelSewing;
using detail::PanelTests;
using detail::PlannedSurface;
using detail::SewnPanels;

class PanelSewingTest : public testing::Test {
protected:
	PlannedSurface plannedWith(int panels) const {
		return {given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, panels))};
	}

	const GivenPatches given = detail::separatePatches(jitteredGrid(12, 12, steepBump), {});
	const std::vector<double> limits = {0.2 * boxDiagonal(given.mesh.positions)};
	bool goOn = true;
	PanelTests tests{limits, {}, [this](double, const std::string&) { return goOn; }};
	PanelSewing sewing{given, limits, {}, tests};
};

TEST_F(PanelSewingTest, DoesNotRunAgainWhatItHasSeen) {
	const SewnPanels first = sewing.sew(plannedWith(2), false);
	const double work = sewing.work();
	const double beside = work - first.work; // to put the panels in place and lay them flat
	EXPECT_GT(beside, 0);
	EXPECT_GT(first.work, 0);
	EXPECT_EQ(first.panels.size(), 2u);
	const SewnPanels again = sewing.sew(plannedWith(2), false);
	EXPECT_EQ(sewing.work(), work);
	EXPECT_EQ(again.maxDisplacement, first.maxDisplacement);
	EXPECT_EQ(again.panels.size(), 2u);
	const SewnPanels other = sewing.sew(plannedWith(3), false);
	EXPECT_EQ(other.panels.size(), 3u);
	const double workOnBoth = sewing.work();
	EXPECT_DOUBLE_EQ(workOnBoth, work + beside + other.work);
	sewing.sew(plannedWith(3), true); // on a surface without a coarse level that is the same
	EXPECT_EQ(sewing.work(), workOnBoth);
}

/// Where a run ends hangs on the last digits of what it begins with.
TEST_F(PanelSewingTest, SewsWithTheDigitsThatTheMeshWillHave) {
	GivenPatches single = given, few = given;
	single.mesh.singlePrecision = true;
	few.mesh.positions = rounded<float>(given.mesh.positions);
	PanelSewing rounds{single, limits, {}, tests}, begins{few, limits, {}, tests};
	const SewnPanels sewn = rounds.sew(plannedWith(2), false);
	const PlannedSurface planned = {few.mesh, few.origins, withPanels(few.mesh, strips(few.mesh, 2))};
	EXPECT_EQ(sewn.meanDisplacement, begins.sew(planned, false).meanDisplacement);
	EXPECT_NE(sewn.meanDisplacement, sewing.sew(plannedWith(2), false).meanDisplacement);
}

/// With a material, what is brief is less than the whole; so it is on coarse levels.
TEST_F(PanelSewingTest, RunsAgainWhatWasBrief) {
	CutOptions strained;
	strained.material.bounds = StrainBounds::isotropic(0.05, 0.05);
	const GivenPatches large = detail::separatePatches(jitteredGrid(60, 60, flatSheet), {});
	for (const bool coarse : {false, true}) {
		const GivenPatches& surface = coarse ? large : given;
		PanelSewing brief{surface, limits, coarse ? CutOptions{} : strained, tests};
		const PlannedSurface planned = {surface.mesh, surface.origins,
										withPanels(surface.mesh, strips(surface.mesh, 2))};
		const SewnPanels first = brief.sew(planned, true);
		EXPECT_EQ(first.coarse, coarse);
		const double beside = brief.work() - first.work;
		EXPECT_GT(beside, 0);
		const SewnPanels whole = brief.sew(planned, false);
		const double workOnBoth = brief.work();
		EXPECT_DOUBLE_EQ(workOnBoth, 2 * beside + first.work + whole.work);
		brief.sew(planned, true);
		EXPECT_EQ(brief.work(), workOnBoth);
	}
}

TEST_F(PanelSewingTest, RunsAgainWhatASlitHasChanged) {
	PlannedSurface planned = plannedWith(1);
	const SewnPanels before = sewing.sew(planned, false);
	const double work = sewing.work();
	const detail::CutSurface& surface = planned.surface;
	for (int h = 0; h < 3 * given.mesh.triangleCount(); ++h)
		if (surface.assembly().across(h) >= 0) {
			planned.surface.setCut(h, true);
			break;
		}
	const SewnPanels after = sewing.sew(planned, false);
	EXPECT_DOUBLE_EQ(sewing.work(), 2 * work - before.work + after.work);
}

/// What comes too far on the surface itself leaves brief runs less room from then on.
TEST_F(PanelSewingTest, IsBriefWithLessRoomAfterARunThatCameTooFar) {
	constexpr double leastRoom = 0.85;
	const double limit = 1.02 * sewing.sew(plannedWith(2), false).maxDisplacement;
	const auto farthestThatHold = [](const SewnPanels& sewn) {
		double farthest = 0;
		for (const CutPanel& panel : sewn.panels)
			farthest = std::max(farthest, panel.developable ? panel.maxDisplacement : 0);
		return farthest;
	};
	PanelSewing fresh{given, {limit}, {}, tests}, warned{given, {limit}, {}, tests};
	EXPECT_GT(farthestThatHold(fresh.sew(plannedWith(2), true)), leastRoom * limit);
	const SewnPanels tooFar = warned.sew(plannedWith(1), false);
	ASSERT_EQ(tooFar.panels[0].reason, Reason::TooFar);
	ASSERT_GT(tooFar.maxDisplacement, limit / leastRoom);
	const SewnPanels brief = warned.sew(plannedWith(2), true);
	EXPECT_LE(farthestThatHold(brief), (1 + 1e-9) * leastRoom * limit);
	EXPECT_EQ(warned.sew(plannedWith(1), true).maxDisplacement, tooFar.maxDisplacement); // is still known
}

/// What a stop has cut short is nothing that was seen.
TEST_F(PanelSewingTest, ForgetsWhatWasStopped) {
	goOn = false;
	sewing.sew(plannedWith(2), false);
	ASSERT_TRUE(tests.stopped());
	const double work = sewing.work();
	sewing.sew(plannedWith(2), false);
	EXPECT_GT(sewing.work(), work);
}

} // namespace
} // namespace developable::test
