// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(Seams, SeamsOfTwoPanelsHaveBothLengthsAndTheirMismatch) {
	const TriangleMesh left = grid(8, 11, quarterCylinder);
	TriangleMesh right = left; // turned about the shared edge at u = 0, x = 1
	right.positions.row(1) *= -1;
	right.triangles.row(1).swap(right.triangles.row(2));
	const FlatPatterns patterns = flattened(together(left, right));
	ASSERT_EQ(patterns.seams.size(), 1u);
	const Seam& seam = patterns.seams[0];
	EXPECT_EQ(seam.piece[0] + seam.piece[1], 1);
	EXPECT_NEAR(seam.length[0], 1, 1e-12);
	EXPECT_NEAR(seam.length[1], 1, 1e-12);
	EXPECT_LT(patterns.report.maxSeamMismatch, 1e-12);
	for (std::size_t i = 0; i < seam.halfEdges[0].size(); ++i) {
		std::array<std::array<int, 2>, 2> places;
		for (const int side : {0, 1}) {
			const int h = seam.halfEdges[side][i];
			places[side] = {patterns.placeOfVertex[patterns.vertexAt(h)],
							patterns.placeOfVertex[patterns.vertexAt(nextCorner(h))]};
			std::sort(places[side].begin(), places[side].end());
		}
		EXPECT_EQ(places[0], places[1]);
	}
}

TEST(Seams, OfThreePanelsAtAnEdgeTwoAreSewnToTheFirstWhateverTheOrderOfTriangles) {
	const auto page = [](double angle) {
		return grid(4, 9, [angle](double u, double v) -> Eigen::Vector3d {
			return {u * std::cos(angle), u * std::sin(angle), v};
		});
	};
	TriangleMesh mesh = together(together(page(0), page(2)), page(4));
	const int third = mesh.triangleCount() / 3;
	const Eigen::Matrix3Xi triangles = mesh.triangles;
	for (int t = 0; t < mesh.triangleCount(); ++t) // the panels take turns, one of them from its end
		mesh.triangles.col(t) = triangles.col(t % 3 * third + (t % 3 != 1 ? t / 3 : third - 1 - t / 3));
	const FlatPatterns patterns = flattened(mesh);
	ASSERT_EQ(patterns.seams.size(), 2u);
	for (const int seam : {0, 1}) {
		EXPECT_EQ(patterns.seams[seam].halfEdges[0].size(), 8u);
		EXPECT_EQ(std::min(patterns.seams[seam].piece[0], patterns.seams[seam].piece[1]), 0);
		EXPECT_EQ(std::max(patterns.seams[seam].piece[0], patterns.seams[seam].piece[1]), seam + 1);
	}
}
TEST(Seams, SeamsBetweenAStrainedAndAFlatPanelDoNotMatch) {
	// A bumped sheet beside a flat one that shares its edge x = 1.
	TriangleMesh left = jitteredGrid(15, 15, bump(0.3, 10)), right = left;
	for (auto p : right.positions.colwise())
		p[0] = 2 - p[0];
	for (int v = 0; v < right.vertexCount(); ++v)
		if (v % 15 != 14)
			right.positions(2, v) = right.positions(2, v - v % 15 + 14);
	const FlatPatterns patterns = flattened(together(left, right));
	ASSERT_EQ(patterns.seams.size(), 1u);
	EXPECT_GT(patterns.report.maxSeamMismatch, 1e-4);
	EXPECT_DOUBLE_EQ(patterns.report.maxSeamMismatch, patterns.seams[0].mismatch());
}

} // namespace
} // namespace developable::test
