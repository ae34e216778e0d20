// SPDX-License-Identifier: GPL-3.0-or-later
// Curves take nodes, keep others from crossing them, and split the triangles that they run through.
#include "developable/panels/curve_network.h"

#include "panel_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CurveNetwork;
using detail::CutSurface;
using detail::SplitMesh;

/// The unit square of 4 x 4 cells; vertex i lies at (i % 5, i / 5) / 4 or the other way round.
struct Sheet {
	TriangleMesh mesh = grid(5, 5, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	CutSurface surface = withPanels(mesh, strips(mesh, 1));
	CurveNetwork network{mesh, surface};

	/// A triangle with no vertex on the border.
	int innerTriangle() const {
		for (int t = 0; t < mesh.triangleCount(); ++t) {
			bool inside = true;
			for (int h = 3 * t; h < 3 * t + 3; ++h)
				inside = inside && surface.assembly().copyInterior[surface.startOf(h)];
			if (inside)
				return t;
		}
		return -1;
	}

	/// Half way along a side of a triangle.
	int middleOf(int halfEdge) {
		return network.nodeAt({vertexAt(mesh, halfEdge), vertexAt(mesh, nextCorner(halfEdge)), 0.4});
	}
};

TEST(CurveNetwork, nodesAreFoundAgain) {
	Sheet sheet;
	const int node = sheet.network.nodeAt({6, 7, 0.4});
	EXPECT_EQ(sheet.network.nodeAt({7, 6, 0.6}), node);
	EXPECT_NE(sheet.network.nodeAt({7, 6, 0.4}), node);
	EXPECT_EQ(sheet.network.nodeAt({6, 6, 0}), 6);
	const Eigen::Vector3d expected = 0.6 * sheet.mesh.positions.col(6) + 0.4 * sheet.mesh.positions.col(7);
	EXPECT_NEAR((sheet.network.pointOf(node) - expected).norm(), 0, 1e-15);
}

TEST(CurveNetwork, noCurveCrossesAnother) {
	Sheet sheet;
	const int t = sheet.innerTriangle(), h = 3 * t;
	const int a = sheet.middleOf(h), b = sheet.middleOf(h + 1), c = sheet.middleOf(h + 2);
	const int start = vertexAt(sheet.mesh, h), apex = vertexAt(sheet.mesh, h + 2);
	EXPECT_TRUE(sheet.network.mayRun(t, apex, a));
	sheet.network.add({start, b});
	EXPECT_FALSE(sheet.network.mayRun(t, apex, a));
	EXPECT_FALSE(sheet.network.mayRun(t, a, c));
	EXPECT_TRUE(sheet.network.mayRun(t, apex, c));
	EXPECT_TRUE(sheet.network.mayRun(t, start, a)) << "along a side";
	sheet.network.remove({start, b});
	EXPECT_TRUE(sheet.network.mayRun(t, apex, a));
	EXPECT_TRUE(sheet.network.mayRun(t, a, c));
}

TEST(CurveNetwork, nodesAreFreeUntilTheyAreTaken) {
	Sheet sheet;
	const int t = sheet.innerTriangle(), h = 3 * t;
	const std::size_t all = sheet.network.freeNodes(t).size();
	EXPECT_EQ(all, 12U) << "three corners, three on each side";
	const std::vector<int> curve = {vertexAt(sheet.mesh, h), sheet.middleOf(h + 1)};
	sheet.network.add(curve);
	const std::vector<int> free = sheet.network.freeNodes(t);
	EXPECT_EQ(free.size(), 10U) << "neither the corner nor what is next to the other end";
	EXPECT_EQ(std::count(free.begin(), free.end(), curve[0]), 0);
	sheet.network.remove(curve);
	EXPECT_EQ(sheet.network.freeNodes(t).size(), all);
	sheet.network.add({vertexAt(sheet.mesh, h), vertexAt(sheet.mesh, h + 1)});
	EXPECT_EQ(sheet.network.freeNodes(t).size(), 7U) << "nothing on a side along which a curve runs";
}

TEST(CurveNetwork, aCurveAlongASideStopsWhereAnotherBegins) {
	Sheet sheet;
	const int t = sheet.innerTriangle(), h = 3 * t;
	for (const int side : {h, h + 1, h + 2}) {
		const int from = vertexAt(sheet.mesh, side);
		const int to = vertexAt(sheet.mesh, nextCorner(side));
		const std::vector<int> other = {sheet.middleOf(side), vertexAt(sheet.mesh, previousCorner(side))};
		EXPECT_TRUE(sheet.network.mayRun(t, from, to));
		sheet.network.add(other);
		EXPECT_FALSE(sheet.network.mayRun(t, from, to));
		sheet.network.remove(other);
	}
}

TEST(CurveNetwork, trianglesAreSplitAlongCurves) {
	Sheet sheet;
	const int t = sheet.innerTriangle(), h = 3 * t;
	const std::vector<int> curve = {vertexAt(sheet.mesh, h), sheet.middleOf(h + 1)};
	sheet.network.add(curve);
	std::vector<char> isCut;
	const SplitMesh split = sheet.network.split(isCut);
	EXPECT_EQ(split.mesh.triangleCount(), sheet.mesh.triangleCount() + 2) << "its neighbour, too";
	EXPECT_EQ(split.mesh.vertexCount(), sheet.mesh.vertexCount() + 1);
	EXPECT_NEAR(CutSurface(assembled(split.mesh)).areas().sum(), 1, 1e-12);
	EXPECT_EQ(std::count(isCut.begin(), isCut.end(), 1), 2) << "one side of each of two triangles";
	EXPECT_EQ(std::count(split.mesh.face.begin(), split.mesh.face.end(), t), 2);
	EXPECT_DOUBLE_EQ(split.origins.back().share, 0.4);
}

} // namespace
} // namespace developable::test
