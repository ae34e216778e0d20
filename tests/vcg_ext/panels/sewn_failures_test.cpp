// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/panels/sewn_failures.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::SewnPanels;

SewnPanels holdingPanels(int count) {
	SewnPanels sewn;
	sewn.panels.resize(count);
	for (CutPanel& panel : sewn.panels) {
		panel.triangles = 10;
		panel.developable = true;
	}
	return sewn;
}

/// Seams have to change at both places that lie upon each other, or it would be chance that it helps.
TEST(SewnFailures, ofOverlapsAreWorstAtBothPlaces) {
	SewnPanels sewn = holdingPanels(3);
	EXPECT_TRUE(worstPoints(sewn).empty());
	const Eigen::Vector3d one(1, 2, 3), other(4, 5, 6);
	sewn.panels[1].developable = false;
	sewn.panels[1].reason = Reason::NeedsCut;
	sewn.panels[1].worstPoint = one;
	EXPECT_EQ(worstPoints(sewn), std::vector<Eigen::Vector3d>({one}));
	sewn.overlaps[1] = {one, other};
	EXPECT_EQ(worstPoints(sewn), std::vector<Eigen::Vector3d>({one, other}));
}

/// Others may fail for nothing else than the worst.
TEST(SewnFailures, areDividedOneAtATimeUnlessEachFailsForItself) {
	SewnPanels sewn = holdingPanels(4);
	for (CutPanel& panel : sewn.panels)
		panel.maxDisplacement = 9;
	EXPECT_TRUE(panelsToDivide(sewn).empty());
	for (const int panel : {1, 2}) {
		sewn.panels[panel].developable = false;
		sewn.panels[panel].reason = Reason::TooFar;
		sewn.panels[panel].maxDisplacement = panel;
		sewn.panels[panel].curvatureAfter = 1e-5 / panel; // rounding
	}
	EXPECT_EQ(panelsToDivide(sewn), std::vector<int>({2}));
	sewn.panels[1].curvatureAfter = 3; // it did not move at all
	sewn.panels[1].reason = Reason::NeedsCut;
	EXPECT_EQ(panelsToDivide(sewn), std::vector<int>({1}));
	sewn.panels[1].curvatureAfter = 0;
	sewn.panels[2].reason = Reason::NeedsCut; // both overlap themselves
	EXPECT_EQ(panelsToDivide(sewn), std::vector<int>({2, 1}));
	for (const int panel : {1, 2})
		sewn.panels[panel].reason = Reason::BeyondBounds;
	EXPECT_EQ(panelsToDivide(sewn), std::vector<int>({2, 1}));
}

TEST(SewnFailures, areOverlapsOnlyWhereNothingElseIsWrong) {
	SewnPanels sewn = holdingPanels(3);
	EXPECT_FALSE(onlyOverlap(sewn)); // none fails
	sewn.panels[1].developable = false;
	sewn.panels[1].reason = Reason::NeedsCut;
	EXPECT_TRUE(onlyOverlap(sewn));
	sewn.panels[2].developable = false;
	sewn.panels[2].reason = Reason::TooFar;
	sewn.panels[2].maxDisplacement = 1;
	EXPECT_FALSE(onlyOverlap(sewn));
	sewn.panels[2].reason = Reason::NeedsCut;
	sewn.panels[2].curvatureAfter = 1;
	EXPECT_FALSE(onlyOverlap(sewn));
}

/// As long as there is time to try; then some at once, or all where most fail.
TEST(SewnFailures, areDividedFasterTheLongerItTakes) {
	SewnPanels sewn = holdingPanels(10);
	sewn.panels[9].triangles = 0; // of no panel any more
	for (int panel = 0; panel < 4; ++panel) {
		sewn.panels[panel].developable = false;
		sewn.panels[panel].reason = Reason::TooFar;
		sewn.panels[panel].maxDisplacement = 1 + panel;
	}
	const std::vector<int> one = {3}, third = {3, 2}, all = {3, 2, 1, 0};
	EXPECT_EQ(panelsToDivideIn(0, true, sewn), one);
	EXPECT_EQ(panelsToDivideIn(7, true, sewn), one);
	EXPECT_EQ(panelsToDivideIn(8, true, sewn), third);
	EXPECT_EQ(panelsToDivideIn(13, true, sewn), third);
	EXPECT_EQ(panelsToDivideIn(14, true, sewn), all);
	EXPECT_EQ(panelsToDivideIn(0, false, sewn), third); // four of nine fail
	sewn.panels[8].triangles = 0;
	EXPECT_EQ(panelsToDivideIn(0, false, sewn), third);
	sewn.panels[7].triangles = 0; // of seven
	EXPECT_EQ(panelsToDivideIn(0, false, sewn), all);
	EXPECT_EQ(panelsToDivideIn(0, true, sewn), one);
}

} // namespace
} // namespace developable::test
