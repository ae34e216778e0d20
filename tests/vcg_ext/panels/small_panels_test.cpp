// SPDX-License-Identifier: GPL-3.0-or-later
// No panel of less than a hundredth, where a neighbour can help.
#include "developable/panels/small_panels.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;

/// A flat sheet with a tiny panel in one corner, beside a large one, and a strip.
CutSurface sheetWithATinyPanel() {
	const TriangleMesh mesh = grid(41, 41, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	return withPanels(mesh, labelsOf(mesh, [](const Eigen::Vector3d& point) {
						  const bool tiny = point.head<2>().maxCoeff() < 0.05;
						  return tiny ? 2 : point[0] > 0.8;
					  }));
}

detail::PanelTests testsOf(const CutSurface& surface) {
	return {std::vector<double>(surface.assembly().patchCount(), 0.02), {}, {}};
}

TEST(SmallPanels, growIntoANeighbour) {
	CutSurface surface = sheetWithATinyPanel();
	ASSERT_EQ(smallPanels(surface).size(), 1U);
	detail::PanelTests tests = testsOf(surface);
	growSmallPanels(surface, tests, {});
	EXPECT_TRUE(smallPanels(surface).empty());
	EXPECT_EQ(surface.usedPanelCount(), 3);
	double least = 1;
	for (const std::vector<int>& panel : panelsOf(surface)) {
		EXPECT_TRUE(detail::isDisk(surface.meshOf(panel)));
		least = std::min(least, surface.area(surface.panelOf(panel.front())));
	}
	EXPECT_GE(least, 0.01);
	EXPECT_LT(least, 0.02); // no more than it takes
}

TEST(SmallPanels, takeNothingThatIsHeld) {
	CutSurface surface = sheetWithATinyPanel();
	const std::set<std::vector<int>> before = panelsOf(surface);
	detail::PanelTests tests = testsOf(surface);
	growSmallPanels(surface, tests, std::vector<char>(surface.assembly().triangleCount(), 1));
	EXPECT_EQ(panelsOf(surface), before);
}

/// A sheet of two strips, and a triangle of the first that is a panel by itself.
CutSurface sheetWithASliver(const Surface& shape, const Eigen::Vector2d& at) {
	const TriangleMesh mesh = grid(41, 41, shape);
	std::vector<int> labels = labelsOf(mesh, [](const Eigen::Vector3d& point) { return point[0] > 0.8; });
	const auto distance = [&](int t) {
		return (mesh.positions(Eigen::all, mesh.triangles.col(t)).rowwise().mean().head<2>() - at).norm();
	};
	int nearest = 0;
	for (int t = 0; t < mesh.triangleCount(); ++t)
		nearest = distance(t) < distance(nearest) ? t : nearest;
	labels[nearest] = 2;
	return withPanels(mesh, labels);
}

TEST(SmallPanels, sliversGoToTheNeighbourRoundThem) {
	CutSurface surface =
		sheetWithASliver([](double u, double v) { return Eigen::Vector3d(u, v, 0); }, {0.4, 0.4});
	ASSERT_EQ(surface.usedPanelCount(), 3);
	detail::PanelTests tests = testsOf(surface);
	detail::JoinHistory history;
	joinSlivers(surface, tests, history);
	EXPECT_EQ(surface.usedPanelCount(), 2);
	int first = 0;
	while (surface.barycentre(first)[0] > 0.8)
		++first;
	EXPECT_TRUE(history.takeBack(surface, surface.panelOf(first)));
	EXPECT_EQ(surface.usedPanelCount(), 3);
}

/// With the sliver at its apex a cone would be closed.
TEST(SmallPanels, sliversStayWhereTheyKeepAPanelOpen) {
	const Surface cone = [](double u, double v) {
		return Eigen::Vector3d(u, v, -std::hypot(u - 0.5, v - 0.5));
	};
	CutSurface surface = sheetWithASliver(cone, {0.51, 0.505});
	ASSERT_EQ(surface.usedPanelCount(), 3);
	detail::PanelTests tests = testsOf(surface);
	detail::JoinHistory history;
	joinSlivers(surface, tests, history);
	EXPECT_EQ(surface.usedPanelCount(), 3);
}

} // namespace
} // namespace developable::test
