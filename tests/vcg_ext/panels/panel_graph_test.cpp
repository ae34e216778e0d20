// SPDX-License-Identifier: GPL-3.0-or-later
// Paths within a panel are the shortest, keep away from its border, and from what is held.
#include "developable/panels/panel_graph.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::PanelGraph;

Eigen::Vector3d at(const CutSurface& surface, int copy) {
	return surface.positions().col(surface.assembly().placeOfCopy[copy]);
}

TEST(PanelGraph, measuresDepths) {
	const CutSurface surface = square();
	const PanelGraph graph(surface, surface.panelOf(0), {});
	const PanelGraph::Paths depths = graph.fromBorder();
	for (int copy = 0; copy < surface.assembly().copyCount(); ++copy) {
		const Eigen::Vector3d point = at(surface, copy);
		EXPECT_NEAR(depths.length[copy], std::min(point.head<2>().minCoeff(), 1 - point.head<2>().maxCoeff()),
					1e-12);
		EXPECT_EQ(graph.onBorder(copy), depths.length[copy] == 0);
	}
	const int middle = graph.nearestTo({0.52, 0.51, 0});
	EXPECT_TRUE(at(surface, middle).isApprox(Eigen::Vector3d(0.5, 0.5, 0)));
	EXPECT_EQ(graph.wayTo(middle, depths).size(), 4U);
}

TEST(PanelGraph, endsAtBordersAndCuts) {
	CutSurface surface = square();
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h) // from above down to the middle
		if (surface.assembly().across(h) >= 0 && std::abs(surface.vectorOf(h)[0]) < 1e-9 &&
			std::abs(surface.middleOf(h)[0] - 0.5) < 1e-9 && surface.middleOf(h)[1] > 0.5)
			surface.setCut(h, true);
	const PanelGraph graph(surface, surface.panelOf(0), {});
	const int left = graph.nearestTo({0.375, 0.75, 0}), right = graph.nearestTo({0.625, 0.75, 0});
	EXPECT_TRUE(graph.onBorder(graph.nearestTo({0.5, 0.75, 0})));
	const PanelGraph::Paths paths = graph.from({left});
	EXPECT_GT(paths.length[right], 0.25 + 1e-9); // round the cut, not through it
	ASSERT_TRUE(paths.reach(right));
	for (const int h : graph.wayTo(right, paths))
		EXPECT_FALSE(surface.isCut(h));
}

TEST(PanelGraph, runsBetweenNoTwoHeldTriangles) {
	const CutSurface surface = square();
	std::vector<char> held(surface.assembly().triangleCount(), 0);
	for (int t = 0; t < surface.assembly().triangleCount(); ++t)
		held[t] = (surface.barycentre(t) - Eigen::Vector3d(0.5, 0.5, 0)).cwiseAbs().maxCoeff() < 0.25;
	const PanelGraph graph(surface, surface.panelOf(0), held);
	EXPECT_FALSE(graph.fromBorder().reach(graph.nearestTo({0.5, 0.5, 0})));
	EXPECT_TRUE(graph.fromBorder().reach(graph.nearestTo({0.125, 0.5, 0})));
}

TEST(PanelGraph, takesTheShortestWay) {
	const CutSurface surface = square();
	const PanelGraph graph(surface, surface.panelOf(0), {});
	const int start = graph.nearestTo({0.125, 0.5, 0}), end = graph.nearestTo({0.875, 0.5, 0});
	for (const int h : graph.wayTo(end, graph.from({start})))
		EXPECT_NEAR(surface.middleOf(h)[1], 0.5, 1e-12);
}

} // namespace
} // namespace developable::test
