// SPDX-License-Identifier: GPL-3.0-or-later
// Of panels that were found elsewhere those are taken over that hold.
#include "developable/panels/panel_plan.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::GivenPatches;
using detail::PanelPlan;
using detail::PlannedSurface;

PanelPlan planOf(const GivenPatches& given) {
	const double limit = 0.02 * boxDiagonal(given.mesh.positions);
	return {{given, {limit}, {}}, [](double, const std::string&) { return true; }};
}

PlannedSurface inStrips(const GivenPatches& given, int count) {
	return {given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, count))};
}

TEST(PanelPlan, takesOverTheFirstThatHold) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(21, 21, steepBump), {});
	PanelPlan plan = planOf(given);
	EXPECT_TRUE(plan.takeOver({inStrips(given, 1), inStrips(given, 9), inStrips(given, 15)}));
	EXPECT_EQ(plan.planned().surface.usedPanelCount(), 9);
	EXPECT_EQ(plan.result().report.status, Status::Converged);
}

TEST(PanelPlan, dividesTheFirstWhereNoneHold) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(21, 21, steepBump), {});
	PanelPlan plan = planOf(given);
	EXPECT_FALSE(plan.takeOver({inStrips(given, 1), inStrips(given, 2)}));
	EXPECT_EQ(plan.planned().surface.usedPanelCount(), 1);
	EXPECT_NE(plan.result().report.status, Status::Converged);
	plan.divide();
	EXPECT_GT(plan.planned().surface.usedPanelCount(), 1);
	EXPECT_EQ(plan.result().report.status, Status::Converged);
}

/// More than one turn of a nearly flat ring: developable with hardly a move, but not laid flat in one piece.
TEST(PanelPlan, dividesWhatOnlyOverlapsItself) {
	const GivenPatches given = detail::separatePatches(
		grid(45, 5,
			 [](double u, double v) {
				 const double angle = 2.2 * pi * u;
				 return Eigen::Vector3d((4 + v) * std::cos(angle), (4 + v) * std::sin(angle),
										0.5 * u + 0.02 * v * v);
			 }),
		{});
	PanelPlan plan = planOf(given);
	EXPECT_FALSE(plan.takeOver(std::vector<PlannedSurface>{inStrips(given, 1)}));
	ASSERT_TRUE(detail::onlyOverlap(plan.sewn()));
	EXPECT_FALSE(plan.sewn().provisional);
	plan.divide();
	EXPECT_EQ(plan.planned().surface.usedPanelCount(), 2);
	EXPECT_EQ(plan.result().report.status, Status::Converged);
}

/// Nothing is sewn for what would not be taken.
TEST(PanelPlan, givesUpWhatIsNotPromising) {
	const GivenPatches given = detail::separatePatches(sphere(1, 3), {});
	PanelPlan plan = planOf(given);
	plan.cluster(0.15);
	plan.join();
	const double work = plan.work();
	const int panels = plan.planned().surface.usedPanelCount();
	int asked = 0;
	EXPECT_FALSE(plan.search([&](const detail::CutSurface& surface) {
		EXPECT_EQ(surface.usedPanelCount(), panels);
		++asked;
		return false;
	}));
	EXPECT_GT(asked, 0);
	EXPECT_FALSE(plan.stopped());
	EXPECT_LT(plan.work(), 1.5 * work);
}

} // namespace
} // namespace developable::test
