// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that is one too many goes to its neighbours; where that is no better all is as it was.
#include "developable/panels/panel_dissolving.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::dissolvePanels;
using detail::JoinHistory;
using detail::PanelTests;

/// All would be one panel, but none may be joined whole.
TEST(PanelDissolving, aPanelThatNoneTakesWholeGoesInPieces) {
	const TriangleMesh mesh = grid(13, 5, flatSheet);
	const std::vector<int> clusters = strips(mesh, 6);
	std::vector<int> panels; // the middle one has two clusters
	for (const int cluster : clusters)
		panels.push_back(cluster / 2);
	CutSurface surface = withPanels(mesh, panels);
	ASSERT_EQ(surface.usedPanelCount(), 3);
	PanelTests tests({1}, {}, {});
	JoinHistory history;
	for (const detail::SeamChain& chain : detail::seamChains(surface))
		history.refuse(surface, chain.halfEdges);
	dissolvePanels(surface, clusters, tests, history);
	EXPECT_LT(surface.usedPanelCount(), 3);
}

TEST(PanelDissolving, whatCannotBeTakenStays) {
	const TriangleMesh mesh = sphere(1, 3);
	const auto octant = [](const Eigen::Vector3d& point) {
		return (point[0] > 0) + 2 * (point[1] > 0) + 4 * (point[2] > 0);
	};
	const std::vector<int> clusters = labelsOf(mesh, octant);
	CutSurface surface = withPanels(mesh, clusters);
	const auto before = panelsOf(surface);
	ASSERT_EQ(before.size(), 8U);
	PanelTests tests({0.005}, {}, {}); // next to nothing may move
	JoinHistory history;
	dissolvePanels(surface, clusters, tests, history);
	EXPECT_EQ(panelsOf(surface), before);
}

} // namespace
} // namespace developable::test
