// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/polygons/triangulate_polygon.h"

#include "contours.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// A star-shaped polygon of random radii, many of its corners reflex.
Contour randomPolygon(int corners, unsigned seed) {
	std::mt19937 random(seed);
	Contour contour(2, corners);
	for (int i = 0; i < corners; ++i) {
		const double angle = 2 * pi * i / corners, radius = 0.3 + double(random()) / std::mt19937::max();
		contour.col(i) << radius * std::cos(angle), radius * std::sin(angle);
	}
	return contour;
}

/// A band round two turns of a spiral.
Contour spiral(int steps) {
	Contour contour(2, 2 * steps);
	for (int i = 0; i < steps; ++i) {
		const double angle = 4 * pi * i / steps;
		const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
		contour.col(i) = (1.3 + angle / 6) * direction;
		contour.col(2 * steps - 1 - i) = (1 + angle / 6) * direction;
	}
	return contour;
}

TEST(TriangulatePolygon, ConvexQuadGetsItsDelaunayDiagonal) {
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(inSpace(kite))), (Edges{{1, 3}}));
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(inSpace(points({{-1, 0}, {0, -2}, {1, 0}, {0, 2}})))),
			  (Edges{{0, 2}}));
}

TEST(TriangulatePolygon, PolygonsOfManyKindsAreConstrainedDelaunay) {
	std::vector<Contour> contours = {kite, comb(7), spiral(40),
									 points({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}),
									 points({{0, 0}, {1, 0}, {2, 0}, {2, 1.1}, {2, 2}, {0.9, 2}, {0, 2}})};
	for (unsigned seed = 0; seed < 40; ++seed)
		contours.push_back(randomPolygon(4 + seed % 23, seed));
	contours.push_back(randomPolygon(100, 77));
	for (const Contour& contour : contours) {
		ASSERT_GT(area(contour), 0);
		const auto triangles = triangulatePolygon(inSpace(contour));
		ASSERT_TRUE(triangles);
		expectConstrainedDelaunay(contour, *triangles);
	}
}

TEST(TriangulatePolygon, RegularPolygonOfAHundredCorners) {
	Contour contour(2, 100);
	for (int i = 0; i < 100; ++i)
		contour.col(i) << std::cos(2 * pi * i / 100), std::sin(2 * pi * i / 100);
	expectConstrainedDelaunay(contour, *triangulatePolygon(inSpace(contour)));
}

TEST(TriangulatePolygon, TriangleIsItself) {
	const auto triangles = triangulatePolygon(inSpace(points({{0, 0}, {2, 0}, {0, 1}})));
	ASSERT_TRUE(triangles);
	EXPECT_EQ(triangles->cols(), 1);
}

TEST(TriangulatePolygon, ContourThatCrossesOrTouchesItselfIsRefused) {
	for (const Contour& contour :
		 {points({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),                         // crosses
		  points({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}),                 // a corner on a side
		  points({{0, 0}, {1, 0}, {2, -1}, {2, 1}, {1, 0}, {0, 1}}),        // a corner on a corner
		  points({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),                         // twice the same
		  points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}),                         // no area
		  points({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 5}, {1, 2}, {0, 2}}), // a spike
		  points({{1, 1}, {1, 1}, {1, 1}})})
		EXPECT_FALSE(triangulatePolygon(inSpace(contour)));
}

TEST(TriangulatePolygon, DoesNotChangeUnderRigidMotionAndScaling) {
	for (unsigned seed = 0; seed < 10; ++seed) {
		const Contour contour = randomPolygon(17, seed);
		const Edges expected = diagonalsOf(*triangulatePolygon(inSpace(contour)));
		for (const double scale : {1e-30, 1e-4, 1.0, 1e6, 1e30}) {
			const Positions positions = moved(inSpace(contour), scale, scale * Eigen::Vector3d(30, -20, 10));
			EXPECT_EQ(diagonalsOf(*triangulatePolygon(positions)), expected) << scale;
		}
		// Seen from behind.
		const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
		EXPECT_EQ(diagonalsOf(*triangulatePolygon(mirror * moved(inSpace(contour), 1, {1, 2, 3}))), expected);
	}
}

TEST(TriangulatePolygon, CurvedPolygonIsTriangulatedInItsLeastSquaresPlane) {
	// Offsets that add up to nothing along any plane leave the least-squares plane of a parallelogram at z =
	// 0. In space the long diagonal would be the better one: its ends are as far apart as before, the others
	// much farther.
	Positions contour(3, 4);
	contour << 0, 4, 5, 1, 0, 0, 3, 3, 0.8, -0.8, 0.8, -0.8;
	ASSERT_GT((contour.col(2) - contour.col(0)).norm(), (contour.col(3) - contour.col(1)).norm());
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(contour)), (Edges{{1, 3}}));

	// A steep polygon, planar all the same.
	const Contour flat = randomPolygon(12, 5);
	Positions tilted = inSpace(flat);
	tilted.row(2) = 50 * tilted.row(0); // so steep that z has most of it
	const Edges expected = diagonalsOf(*triangulatePolygon(tilted));
	Contour stretched = flat;
	stretched.row(0) *= std::sqrt(1 + 50.0 * 50);
	expectConstrainedDelaunay(stretched, *triangulatePolygon(tilted));
	EXPECT_NE(expected,
			  diagonalsOf(*triangulatePolygon(inSpace(flat)))); // z = 0 would have been the wrong plane
}

} // namespace
} // namespace developable::test
