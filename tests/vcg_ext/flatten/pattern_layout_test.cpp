// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <array>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(PatternLayout, AQuarterCylinderBecomesARectangle) {
	const int columns = 30;
	const FlatPatterns patterns = flattened(grid(columns, 10, quarterCylinder));
	const Eigen::Vector2d size =
		patterns.positions.rowwise().maxCoeff() - patterns.positions.rowwise().minCoeff();
	const double arc = 2 * (columns - 1) * std::sin(pi / 4 / (columns - 1)); // of chords
	// Its longest side stands upright.
	EXPECT_NEAR(size[1], arc, 1e-12);
	EXPECT_NEAR(size[0], 1, 1e-12);
}

TEST(PatternLayout, OfSidesThatAreNearlyAlikeTheSameIsTheLongestWhicheverItIs) {
	const auto longestSide = [](double width, double height) {
		const FlatPatterns patterns = flattened(
			grid(8, 8, [&](double u, double v) { return Eigen::Vector3d(width * u, height * v, 0); }));
		std::array<int, 2> places = patterns.pieces.front().longestSide;
		for (int& end : places)
			end = patterns.placeOfVertex[end];
		return places;
	};
	EXPECT_EQ(longestSide(1, 1.05),
			  longestSide(1.05, 1)); // so the grain does not jump when a square is moved
	EXPECT_NE(longestSide(1, 1.3), longestSide(1.3, 1));
}

TEST(PatternLayout, PiecesLieApartByTheGap) {
	TriangleMesh mesh = grid(6, 6, quarterCylinder);
	for (int copy = 1; copy < 7; ++copy) {
		TriangleMesh other = grid(5, 4 + copy, coneBand);
		other.positions.row(2).array() += 5 * copy;
		mesh = together(mesh, other);
	}
	for (const double gap : {0.0, 0.5, -1.0}) {
		const FlatPatterns patterns = flattened(mesh, {gap, 400});
		std::vector<Eigen::AlignedBox2d> boxes(7);
		double largest = 0;
		for (int v = 0; v < patterns.vertexCount(); ++v)
			boxes[patterns.pieceOfVertex[v]].extend(patterns.positions.col(v));
		for (const auto& box : boxes)
			largest = std::max(largest, box.diagonal().norm());
		const double expected = gap < 0 ? 0.02 * largest : gap;
		double nearest = std::numeric_limits<double>::infinity();
		for (int a = 0; a < 7; ++a)
			for (int b = 0; b < a; ++b)
				nearest = std::min(nearest, boxes[a].exteriorDistance(boxes[b]));
		EXPECT_NEAR(nearest, expected, 1e-12);
		EXPECT_EQ(patterns.report.overlappingPieces, 0);
		EXPECT_EQ(patterns.report.pieces, 7);
	}
}

} // namespace
} // namespace developable::test
