// SPDX-License-Identifier: GPL-3.0-or-later
// Where a piece that is laid flat crosses itself: the shorter ways round it.
#include "developable/panels/border_parts.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::BorderPart;
using detail::coveredStretch;
using detail::notchesOf;

FlatPiece crossingAt(std::vector<std::array<int, 2>> crossings) {
	FlatPiece piece;
	piece.overlapping = true;
	piece.crossings = std::move(crossings);
	return piece;
}

/// The half edge of the border whose middle is there.
int borderAt(const PatchAssembly& assembly, double x, double y) {
	const Eigen::Vector3d at(x, y, 0);
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const Eigen::Vector3d middle = (assembly.originalPositions.col(assembly.placeAt(h)) +
										assembly.originalPositions.col(assembly.placeAt(nextCorner(h)))) /
									   2;
		if (assembly.across(h) < 0 && (middle - at).norm() < 1e-9)
			return h;
	}
	return -1;
}

TEST(BorderParts, goTheShorterWay) {
	const PatchAssembly assembly =
		assembled(grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); }));
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
	const int low = borderAt(assembly, 0.0625, 0), left = borderAt(assembly, 0, 0.1875);
	ASSERT_GE(std::min(low, left), 0);
	for (const auto& ends : {std::array<int, 2>{low, left}, std::array<int, 2>{left, low}}) {
		const std::vector<BorderPart> notches = notchesOf(patterns, crossingAt({ends}));
		ASSERT_EQ(notches.size(), 1U);
		const BorderPart& part = notches.front();
		EXPECT_EQ(part.halfEdges.size(), 3U); // round the corner
		EXPECT_NEAR(part.share, 3.0 / 32, 1e-6);
		EXPECT_EQ(std::min(part.halfEdges.front(), part.halfEdges.back()), std::min(low, left));
		EXPECT_EQ(std::max(part.halfEdges.front(), part.halfEdges.back()), std::max(low, left));
	}
}

/// Round two corners; the second pair of edges is within the first's way, and the last is across the place
/// where the border's half edges begin to be counted.
TEST(BorderParts, areNoPartsOfOthers) {
	const PatchAssembly assembly =
		assembled(grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); }));
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
	const int low = borderAt(assembly, 0.1875, 0), left = borderAt(assembly, 0, 0.1875);
	const int lower = borderAt(assembly, 0.0625, 0), lefter = borderAt(assembly, 0, 0.0625);
	const int high = borderAt(assembly, 0.9375, 1), right = borderAt(assembly, 1, 0.8125);
	std::vector<BorderPart> notches =
		notchesOf(patterns, crossingAt({{lower, lefter}, {low, left}, {right, high}, {low, left}}));
	ASSERT_EQ(notches.size(), 2U);
	EXPECT_NEAR(largestNotch(notches).share, 4.0 / 32, 1e-6);
	EXPECT_EQ(largestNotch(notches).halfEdges.size(), 4U);
	EXPECT_NEAR(notches[0].share + notches[1].share, 7.0 / 32, 1e-6);
	EXPECT_TRUE(notchesOf(patterns, crossingAt({})).empty());
}

TEST(BorderParts, areOfOneBorder) {
	TriangleMesh mesh = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	std::vector<int> kept;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const Eigen::Vector3d at = mesh.positions(Eigen::all, mesh.triangles.col(t)).rowwise().mean();
		if ((at - Eigen::Vector3d(0.5, 0.5, 0)).cwiseAbs().maxCoeff() > 0.25)
			kept.push_back(t);
	}
	mesh.triangles = Eigen::Matrix3Xi(mesh.triangles(Eigen::all, kept));
	mesh.face.resize(kept.size());
	mesh.triangleSelected.assign(kept.size(), 0);
	const PatchAssembly ring = assembled(mesh);
	const FlatPatterns patterns = flattenPatches(ring, ring.originalPositions);
	const int outer = borderAt(ring, 0.0625, 0), inner = borderAt(ring, 0.25, 0.4375);
	ASSERT_GE(std::min(outer, inner), 0);
	const std::vector<BorderPart> notches = notchesOf(patterns, crossingAt({{outer, inner}}));
	ASSERT_EQ(notches.size(), 1U);
	EXPECT_TRUE(notches.front().halfEdges.empty());
	EXPECT_EQ(notches.front().share, 1);
	EXPECT_TRUE(std::isinf(coveredStretch(patterns, crossingAt({{outer, inner}}))));
}

/// Four quadrilaterals round a square, 1 wide, the last of which ends below or above where the first has its
/// upper side.
TEST(BorderParts, lieUponTheirPieceAsFarAsTheyDo) {
	const double outer[5][2] = {{0.2, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
	const double inner[5][2] = {{0.2, 1}, {8, 1}, {8, 8}, {1, 8}, {1, 0}};
	const PatchAssembly assembly =
		assembled(grid(5, 2, [](double u, double v) { return Eigen::Vector3d(u, v, 0); }));
	FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
	const int border = borderAt(assembly, 0.125, 0);
	ASSERT_GE(border, 0);
	EXPECT_EQ(coveredStretch(patterns, crossingAt({{border, border}})), 0);
	for (const auto& [height, covered] : {std::make_pair(0.7, 1.0), {1.2, 0.0}}) {
		for (int vertex = 0; vertex < patterns.vertexCount(); ++vertex) {
			const Eigen::Vector3d at = assembly.originalPositions.col(patterns.placeOfVertex[vertex]);
			const auto column = std::lround(4 * at[0]);
			const auto& to = at[1] == 0 ? outer[column] : inner[column];
			patterns.positions.col(vertex) << to[0], column == 4 ? height : to[1];
		}
		EXPECT_EQ(coveredStretch(patterns, crossingAt({{border, border}})), covered);
	}
	EXPECT_TRUE(std::isinf(coveredStretch(patterns, crossingAt({}))));
}

/// Two triangles with a vertex in common: round it there are two ways on, and one never leads back.
TEST(BorderParts, areOfBordersThatDoNotTouchThemselves) {
	FlatPatterns patterns;
	patterns.positions.resize(2, 5);
	patterns.positions << 0, 1, 1, -1, -1, 0, 0, 1, 0, 1;
	patterns.triangles.resize(3, 2);
	patterns.triangles << 0, 0, 1, 4, 2, 3;
	patterns.joinedHalfEdge.assign(6, -1);
	EXPECT_TRUE(notchesOf(patterns, crossingAt({{0, 2}})).front().halfEdges.empty());
	EXPECT_FALSE(notchesOf(patterns, crossingAt({{3, 5}})).front().halfEdges.empty());
}

} // namespace
} // namespace developable::test
