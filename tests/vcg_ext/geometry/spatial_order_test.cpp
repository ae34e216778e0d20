// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/spatial_order.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(SpatialOrder, NumbersEachPointOnceAndNeighboursClosely) {
	const int side = 64;
	const TriangleMesh mesh = grid(side, side, flatSheet);
	const std::vector<int> order = spatialOrder(mesh.positions);
	std::vector<int> number(order.size(), -1);
	for (int i = 0; i < side * side; ++i)
		number[order[i]] = i;
	EXPECT_EQ(std::count(number.begin(), number.end(), -1), 0);
	int near = 0;
	for (int v = side; v < side * side; ++v)
		near += std::abs(number[v] - number[v - side]) < side / 2; // row by row all of them are `side` apart
	EXPECT_GT(near, 0.7 * side * side);
}

TEST(SpatialOrder, TakesWhatIsNotANumber) {
	Positions points = grid(8, 8, flatSheet).positions;
	for (const double strange : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
		points(1, 20) = strange;
		std::vector<int> order = spatialOrder(points);
		std::sort(order.begin(), order.end());
		for (int i = 0; i < 64; ++i)
			EXPECT_EQ(order[i], i);
	}
}

} // namespace
} // namespace developable::test
