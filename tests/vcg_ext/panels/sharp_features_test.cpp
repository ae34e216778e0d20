// SPDX-License-Identifier: GPL-3.0-or-later
// What was made sharp is told from the corners of a round shape.
#include "developable/panels/sharp_features.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::SharpFeatures;
using detail::sharpFeatures;

/// Two slopes that meet in a ridge along y; its vertices are so far beside the middle, by turns.
TriangleMesh roof(double zigzag) {
	const int columns = 9;
	TriangleMesh mesh = grid(columns, 9, [](double u, double v) { return Eigen::Vector3d(u - 0.5, v, 0); });
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
		auto at = mesh.positions.col(vertex);
		const int row = vertex / columns;
		if (std::abs(at[0]) < 1e-9)
			at[0] += (row % 2 == 0 ? 1 : -1) * zigzag;
		else
			at[2] = -0.6 * std::abs(at[0]);
	}
	return mesh;
}

/// A prism that goes round with so many sides, each of so many strips.
TriangleMesh prism(int sides, int stripsOfSide) {
	return grid(sides * stripsOfSide + 1, 5, [=](double u, double v) {
		const double along = u * sides;
		const int side = std::min(sides - 1, static_cast<int>(along));
		const auto corner = [&](int i) {
			return Eigen::Vector3d(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), 2 * v);
		};
		return Eigen::Vector3d(corner(side) + (along - side) * (corner(side + 1) - corner(side)));
	});
}

int count(const std::vector<SharpFeatures::Kind>& kinds, SharpFeatures::Kind kind) {
	return static_cast<int>(std::count(kinds.begin(), kinds.end(), kind));
}

TEST(SharpFeatures, anEdgeBesideFlatFacesIsAlone) {
	const CutSurface surface(assembled(roof(0)));
	const SharpFeatures features = sharpFeatures(surface, 40);
	EXPECT_EQ(count(features.edges, SharpFeatures::Alone), 2 * 8); // both half edges of the ridge
	EXPECT_EQ(count(features.edges, SharpFeatures::AmongOthers), 0);
	const SharpFeatures none = sharpFeatures(surface, 91); // the ridge turns by 62°
	EXPECT_EQ(count(none.edges, SharpFeatures::None), static_cast<int>(none.edges.size()));
}

TEST(SharpFeatures, aJaggedLineOfEdgesIsNone) {
	const CutSurface surface(assembled(roof(0.04)));
	const SharpFeatures features = sharpFeatures(surface, 40);
	int onRidge = 0;
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h) {
		const double ends = std::abs(surface.positions()(2, surface.assembly().placeAt(h))) +
							std::abs(surface.positions()(2, surface.assembly().placeAt(nextCorner(h))));
		if (ends > 0 || surface.across(h) < 0)
			continue;
		++onRidge;
		EXPECT_EQ(int(features.edges[h]), int(SharpFeatures::AmongOthers));
	}
	EXPECT_EQ(onRidge, 2 * 8);
}

TEST(SharpFeatures, aRoundShapeOfFewTrianglesHasNoneAlone) {
	const SharpFeatures round = sharpFeatures(CutSurface(assembled(prism(6, 1))), 40);
	EXPECT_EQ(count(round.edges, SharpFeatures::Alone), 0);
	EXPECT_EQ(count(round.edges, SharpFeatures::AmongOthers), 2 * 5 * 4);
	const SharpFeatures prismatic = sharpFeatures(CutSurface(assembled(prism(6, 4))), 40);
	EXPECT_EQ(count(prismatic.edges, SharpFeatures::Alone), 2 * 5 * 4);
	EXPECT_EQ(count(prismatic.edges, SharpFeatures::AmongOthers), 0);
}

TEST(SharpFeatures, theApexOfAConeIsAlone) {
	TriangleMesh cone = grid(9, 9, [](double u, double v) {
		return Eigen::Vector3d(u - 0.5, v - 0.5, -2 * std::max(std::abs(u - 0.5), std::abs(v - 0.5)));
	});
	const SharpFeatures features = sharpFeatures(CutSurface(assembled(cone)), 40);
	EXPECT_EQ(count(features.points, SharpFeatures::Alone), 1);
	const SharpFeatures coarse = sharpFeatures(CutSurface(assembled(sphere(1, 1))), 40);
	EXPECT_EQ(count(coarse.points, SharpFeatures::Alone), 0);
	EXPECT_GT(count(coarse.points, SharpFeatures::AmongOthers), 0);
}

} // namespace
} // namespace developable::test
