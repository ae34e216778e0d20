// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/indices.h"

#include <gtest/gtest.h>

#include <set>

namespace developable::test {
namespace {

constexpr int cornerCount = 3 * 5;

TEST(Indices, CornerIsItsTriangleAndItsNumberThere) {
	for (int corner = 0; corner < cornerCount; ++corner) {
		EXPECT_EQ(cornerOf(triangleOf(corner), cornerInTriangle(corner)), corner);
		EXPECT_TRUE(cornerInTriangle(corner) >= 0 && cornerInTriangle(corner) < 3);
	}
	EXPECT_EQ(cornerOf(4, 2), 14);
	EXPECT_EQ(triangleOf(14), 4);
}

TEST(Indices, NextAndPreviousAreInverseAndStayInTheTriangle) {
	for (int corner = 0; corner < cornerCount; ++corner) {
		EXPECT_EQ(previousCorner(nextCorner(corner)), corner);
		EXPECT_EQ(nextCorner(previousCorner(corner)), corner);
		EXPECT_EQ(triangleOf(nextCorner(corner)), triangleOf(corner));
		EXPECT_EQ(nextCorner(nextCorner(corner)), previousCorner(corner));
		EXPECT_EQ(std::set<int>({corner, nextCorner(corner), previousCorner(corner)}).size(), 3u);
	}
}

TEST(Indices, NextCornerCountsUpWithinTheTriangle) {
	for (int corner = 0; corner < cornerCount; ++corner)
		EXPECT_EQ(cornerInTriangle(nextCorner(corner)), (cornerInTriangle(corner) + 1) % 3);
	static_assert(nextCorner(0) == 1 && nextCorner(1) == 2 && nextCorner(2) == 0);
	static_assert(previousCorner(0) == 2 && previousCorner(1) == 0 && previousCorner(2) == 1);
}

} // namespace
} // namespace developable::test
