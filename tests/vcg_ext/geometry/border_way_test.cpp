// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// Of edges that are 1, 2, 3, 4 and 5 long.
const std::vector<double> begins = {0, 1, 3, 6, 10, 15};

TEST(BorderWay, GoesRoundTheShorterSide) {
	for (const auto& [a, b] : {std::pair(0, 2), std::pair(2, 0)}) {
		const detail::BorderWay way = detail::shorterWay(begins, a, b);
		EXPECT_EQ(way.first, 0);
		EXPECT_EQ(way.count, 3);
		EXPECT_EQ(way.length, 6);
	}
}

/// Fewer edges may be the longer way.
TEST(BorderWay, GoesPastWhereTheBorderBegins) {
	const detail::BorderWay way = detail::shorterWay(begins, 1, 4);
	EXPECT_EQ(way.first, 4);
	EXPECT_EQ(way.count, 3);
	EXPECT_EQ(way.length, 8);
}

TEST(BorderWay, OfOneEdgeIsThatEdge) {
	for (int edge = 0; edge < 5; ++edge) {
		const detail::BorderWay way = detail::shorterWay(begins, edge, edge);
		EXPECT_EQ(way.first, edge);
		EXPECT_EQ(way.count, 1);
		EXPECT_EQ(way.length, edge + 1);
	}
}

} // namespace
} // namespace developable::test
