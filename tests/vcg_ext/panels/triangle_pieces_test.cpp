// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons fall into triangles along their chords, none of them flatter than need be.
#include "developable/panels/triangle_pieces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::trianglesOfPolygon;

using Triangles = std::vector<std::array<int, 3>>;

/// A right triangle with points on two of its sides.
Eigen::Matrix3Xd triangleWithPoints() {
	Eigen::Matrix3Xd points(3, 5);
	points << 0, 0.5, 1, 0, 0, //
		0, 0, 0, 1, 0.25,      //
		0, 0, 0, 0, 0;
	return points;
}

double heightOf(const Eigen::Matrix3Xd& points, const std::array<int, 3>& corners) {
	const Eigen::Vector3d u = points.col(corners[1]) - points.col(corners[0]);
	const Eigen::Vector3d v = points.col(corners[2]) - points.col(corners[0]);
	return u.cross(v).z(); // twice the area, with its sign
}

bool hasSide(const std::array<int, 3>& corners, int a, int b) {
	for (int i = 0; i < 3; ++i)
		if (corners[i] == a && corners[(i + 1) % 3] == b)
			return true;
	return false;
}

TEST(TrianglesOfPolygon, aTriangleStaysOne) {
	const Triangles triangles = trianglesOfPolygon(triangleWithPoints()(Eigen::all, {0, 2, 3}), {});
	ASSERT_EQ(triangles.size(), 1U);
	EXPECT_DOUBLE_EQ(heightOf(triangleWithPoints()(Eigen::all, {0, 2, 3}), triangles[0]), 1);
}

TEST(TrianglesOfPolygon, chordsAreSidesOfTwoTriangles) {
	const Eigen::Matrix3Xd points = triangleWithPoints();
	const Triangles triangles = trianglesOfPolygon(points, {{4, 1}});
	ASSERT_EQ(triangles.size(), 3U);
	int along = 0, against = 0;
	double area = 0;
	for (const std::array<int, 3>& corners : triangles) {
		EXPECT_GT(heightOf(points, corners), 0.1) << "flat, or turned over";
		area += heightOf(points, corners);
		along += hasSide(corners, 1, 4);
		against += hasSide(corners, 4, 1);
	}
	EXPECT_DOUBLE_EQ(area, 1);
	EXPECT_EQ(along, 1);
	EXPECT_EQ(against, 1);
}

TEST(TrianglesOfPolygon, pointsOnOneLineMakeNoTriangle) {
	for (const Triangles& triangles :
		 {trianglesOfPolygon(triangleWithPoints(), {}), trianglesOfPolygon(triangleWithPoints(), {{1, 3}})}) {
		EXPECT_EQ(triangles.size(), 3U);
		for (const std::array<int, 3>& corners : triangles)
			EXPECT_GT(heightOf(triangleWithPoints(), corners), 0.1);
	}
}

TEST(TrianglesOfPolygon, theWorstTriangleIsAsGoodAsCanBe) {
	Eigen::Matrix3Xd kite(3, 4);
	kite << 0, 5, 10, 5, //
		0, -1, 0, 1,     //
		0, 0, 0, 0;
	for (const std::array<int, 3>& corners : trianglesOfPolygon(kite, {}))
		EXPECT_TRUE(hasSide(corners, 1, 3) || hasSide(corners, 3, 1)) << "the short diagonal";
}

} // namespace
} // namespace developable::test
