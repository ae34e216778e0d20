// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/triangle_intersection.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(TriangleIntersection, KnowsDisjointCrossingAndJoinedTriangles) {
	Positions positions(3, 7);
	positions << 0, 1, 0, 0.2, 0.2, 0.2, 0.5, /**/ 0, 0, 1, 0.2, 0.2, 0.9, 0.5, /**/ 0, 0, 0, -1, 1, 1, -0.5;
	const auto triangle = [&](int a, int b, int c) {
		return PlacedTriangle({a, b, c}, positions(Eigen::all, {a, b, c}));
	};
	EXPECT_TRUE(intersect(triangle(0, 1, 2), triangle(3, 4, 5)));  // pierced by an edge
	EXPECT_FALSE(intersect(triangle(0, 1, 2), triangle(0, 1, 4))); // joined along an edge
	EXPECT_FALSE(intersect(triangle(0, 1, 2), triangle(0, 4, 5))); // joined at a vertex, above
	EXPECT_TRUE(intersect(triangle(0, 1, 2), triangle(0, 4, 3)));  // joined at a vertex, through
	EXPECT_FALSE(intersect(triangle(0, 1, 2), triangle(1, 4, 5))); // the same on the other side
}

} // namespace
} // namespace developable::test
