// SPDX-License-Identifier: GPL-3.0-or-later
// Slits are found again on another surface, and a panel that has one stays one panel.
#include "developable/panels/slit_labels.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::SlitLabels;

/// The unit square in one panel, its two halves joined along a share of the line between them only.
CutSurface withSlit(const TriangleMesh& mesh, const std::vector<int>& halves, double open) {
	CutSurface surface = withPanels(mesh, halves);
	std::vector<int> joined;
	const std::vector<detail::SeamChain> chains = detail::seamChains(surface);
	for (const int h : chains.front().halfEdges)
		if (surface.middleOf(h)[1] < open)
			joined.push_back(h);
	surface.join(joined);
	return surface;
}

TEST(SlitLabels, aPanelStaysOneHoweverLongItsSlitIs) {
	const TriangleMesh mesh = grid(21, 21, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const std::vector<int> halves = strips(mesh, 2);
	for (const double open : {0.8, 0.2}) {
		const CutSurface surface = withSlit(mesh, halves, open);
		ASSERT_EQ(surface.usedPanelCount(), 1);
		const SlitLabels labels(surface, halves);
		EXPECT_EQ(labels.count(), 2);
		CutSurface other = withPanels(mesh, halves);
		labels.openWithin(other, labels.labels());
		EXPECT_EQ(other.usedPanelCount(), 1);
	}
}

TEST(SlitLabels, panelsThatWereTwoStayTwo) {
	const TriangleMesh mesh = grid(21, 21, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const CutSurface surface = withPanels(mesh, strips(mesh, 2));
	const SlitLabels labels(surface, strips(mesh, 4));
	EXPECT_EQ(labels.count(), 2);
	CutSurface other = withPanels(mesh, labels.labels());
	labels.openWithin(other, labels.labels());
	EXPECT_EQ(other.usedPanelCount(), 2);
}

} // namespace
} // namespace developable::test
