// SPDX-License-Identifier: GPL-3.0-or-later
// A dart is the shortest way from the border to its tip, or leads inwards from a point of the border.
#include "developable/panels/relief_darts.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::cutDart;
using detail::CutSurface;
using detail::Dart;
using detail::SeamChain;
using detail::seamChains;

/// Two panels side by side on the unit square of 8 x 8 cells: the left one is x < 0.5.
CutSurface halves() {
	const TriangleMesh mesh = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	return withPanels(mesh, strips(mesh, 2));
}

/// The dart, as the chain that it is.
SeamChain dartOf(const CutSurface& surface) {
	for (const SeamChain& chain : seamChains(surface))
		if (chain.isDart())
			return chain;
	return {};
}

TEST(ReliefDarts, leadToAPointInsideTheShortestWay) {
	CutSurface surface = halves();
	const Eigen::Vector3d tip(0.25, 0.625, 0);
	const int panel = surface.panelOf(0);
	const Dart dart = cutDart(surface, panel, tip, 0.1, {});
	EXPECT_NEAR(dart.length, 0.25, 1e-12); // to the side at x = 0, or the seam at x = 0.5
	EXPECT_LT((dart.tip - tip).norm(), 1e-12);
	EXPECT_EQ(surface.usedPanelCount(), 2); // the panel keeps together
	const SeamChain chain = dartOf(surface);
	EXPECT_NEAR(chain.length, 0.25, 1e-12);
	EXPECT_EQ(surface.panelOf(triangleOf(chain.halfEdges.front())), panel);
}

TEST(ReliefDarts, leadInwardsFromAPointOfTheBorder) {
	for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0.5, 0), Eigen::Vector3d(0.5, 0.5, 0)}) {
		CutSurface surface = halves();
		const Dart dart = cutDart(surface, surface.panelOf(0), at, 0.4, {}); // of a root of the area of 0.7
		EXPECT_NEAR(dart.length, 0.25, 1e-12);                               // no point is deeper inside
		EXPECT_NEAR(dart.tip[0], 0.25, 1e-12);
		EXPECT_EQ(surface.usedPanelCount(), 2);
		EXPECT_EQ(dartOf(surface).halfEdges.size(), 2U);
	}
}

TEST(ReliefDarts, doNotRunBetweenTrianglesThatAreHeld) {
	CutSurface surface = halves();
	const Eigen::Vector3d tip(0.25, 0.625, 0);
	std::vector<char> held; // a strip along the side at x = 0
	for (int t = 0; t < surface.assembly().triangleCount(); ++t)
		held.push_back(surface.middleOf(3 * t)[0] < 0.2);
	const Dart dart = cutDart(surface, surface.panelOf(0), tip, 0.1, held);
	EXPECT_NEAR(dart.length, 0.25, 1e-12); // from the seam
	for (const int h : dartOf(surface).halfEdges)
		EXPECT_FALSE(held[triangleOf(h)] && held[triangleOf(surface.assembly().across(h))]);
	std::fill(held.begin(), held.end(), 1);
	CutSurface whole = halves();
	EXPECT_EQ(cutDart(whole, whole.panelOf(0), tip, 0.1, held).length, 0);
}

TEST(ReliefDarts, thereMayBeNoRoomForOne) {
	CutSurface surface(assembled(grid(2, 2, flatSheet)));
	const Dart dart = cutDart(surface, 0, surface.positions().col(0), 1, {});
	EXPECT_EQ(dart.length, 0);
	EXPECT_TRUE(seamChains(surface).empty());
}

} // namespace
} // namespace developable::test
