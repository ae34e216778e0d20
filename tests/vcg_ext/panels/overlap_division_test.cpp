// SPDX-License-Identifier: GPL-3.0-or-later
// A panel is divided half way between two points.
#include "developable/panels/overlap_division.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::divideBetween;

TEST(OverlapDivision, isHalfWay) {
	CutSurface surface = square();
	ASSERT_TRUE(divideBetween(surface, surface.panelOf(0), {{{0, 0.5, 0}, {1, 0.5, 0}}}));
	EXPECT_EQ(surface.usedPanelCount(), 2);
	for (int t = 0; t < surface.assembly().triangleCount(); ++t)
		EXPECT_NEAR(surface.area(surface.panelOf(t)), 0.5, 0.07); // to within a column of triangles
	EXPECT_NE(surface.panelOf(0), surface.panelOf(surface.assembly().triangleCount() - 1));
}

TEST(OverlapDivision, needsTwoTriangles) {
	CutSurface surface = square();
	EXPECT_FALSE(divideBetween(surface, surface.panelOf(0), {{{0.5, 0.5, 0}, {0.5, 0.5, 0}}}));
	EXPECT_EQ(surface.usedPanelCount(), 1);
}

} // namespace
} // namespace developable::test
