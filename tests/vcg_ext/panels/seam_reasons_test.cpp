// SPDX-License-Identifier: GPL-3.0-or-later
// Why panels are no larger: closed forms whose reason is known.
#include "developable/panels/cut_into_panels.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(SeamReasons, ofATubeIsThatItCloses) {
	const CutReport report = cutIntoPanels(tube(24, 9), {}, {}).report;
	ASSERT_EQ(report.panels.size(), 1U);
	EXPECT_GT(report.seamLength, 0);
	EXPECT_EQ(report.panels[0].reason, Reason::SeamNoSheet);
	EXPECT_EQ(report.panels[0].neighbour, 0);
	EXPECT_NEAR(report.panels[0].seamPoint.head<2>().norm(), 1, 1e-9);
}

TEST(SeamReasons, ofASphereIsThatItWouldMoveTooFar) {
	const CutReport report = cutIntoPanels(sphere(1, 2), {}, {}).report;
	ASSERT_GT(report.panels.size(), 1U);
	for (std::size_t panel = 0; panel < report.panels.size(); ++panel) {
		EXPECT_TRUE(report.panels[panel].developable);
		EXPECT_EQ(report.panels[panel].reason, Reason::SeamTooFar);
		EXPECT_GE(report.panels[panel].neighbour, 0);
		EXPECT_LT(report.panels[panel].neighbour, int(report.panels.size()));
	}
}

TEST(SeamReasons, areNoneWhereNothingIsCut) {
	const CutReport report = cutIntoPanels(grid(9, 9, quarterCylinder), {}, {}).report;
	ASSERT_EQ(report.panels.size(), 1U);
	EXPECT_EQ(report.panels[0].reason, Reason::AsStatus);
	EXPECT_EQ(report.panels[0].neighbour, -1);
}

} // namespace
} // namespace developable::test
