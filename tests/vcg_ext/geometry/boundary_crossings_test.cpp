// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// A strip, 1 wide, that goes round a square and comes down upon its beginning, which is 1 high.
/// \param height  where it ends
Eigen::Matrix2Xd strip(double height) {
	Eigen::Matrix2Xd border(2, 10);
	border << 0.2, 9, 9, 0, 0, 1, 1, 8, 8, 0.2, //
		0, 0, 9, 9, height, height, 8, 8, 1, 1;
	return border;
}

std::size_t crossings(const Eigen::Matrix2Xd& border) {
	std::vector<detail::BoundarySegment> segments;
	const int count = static_cast<int>(border.cols());
	for (int i = 0; i < count; ++i)
		segments.push_back({i, (i + 1) % count, 0, i});
	return detail::crossingPieces(border, segments, 1).front().itself.size();
}

/// A square with a notch in its upper side, whose own sides cross on the way to its bottom, or do not.
TEST(BoundaryCrossings, OfANotchAreOfASliver) {
	for (const double width : {0.1, -0.1}) {
		Eigen::Matrix2Xd border(2, 9);
		border << 0, 4, 4, 2.1, 2 + width, 2, 2 - width, 1.9, 0, //
			0, 0, 4, 4, 3.4, 3, 3.4, 4, 4;
		EXPECT_EQ(crossings(border), width > 0 ? 0U : 1U) << width;
		const double covered = detail::longestCoveredStretch(border), below = std::hypot(0.1, 0.4);
		EXPECT_GE(covered, width > 0 ? 0 : 2 * below);
		EXPECT_LE(covered, width > 0 ? 0 : 2 * below + 2 * std::hypot(0.2, 0.6)); // with those that cross
	}
}

TEST(BoundaryCrossings, OfAnEndUponItsBeginningAreAsLongAsTheEnd) {
	EXPECT_EQ(crossings(strip(1.2)), 0U);
	EXPECT_EQ(detail::longestCoveredStretch(strip(1.2)), 0);
	EXPECT_EQ(crossings(strip(0.7)), 2U); // with the beginning's front and with its upper side
	EXPECT_EQ(detail::longestCoveredStretch(strip(0.7)), 1);
}

TEST(BoundaryCrossings, AreTheSameWhereverABorderBegins) {
	const Eigen::Matrix2Xd border = strip(0.7);
	Eigen::Matrix2Xd turned(2, border.cols());
	for (Eigen::Index first = 0; first < border.cols(); ++first) {
		for (Eigen::Index i = 0; i < border.cols(); ++i)
			turned.col(i) = border.col((first + i) % border.cols());
		EXPECT_EQ(crossings(turned), crossings(border));
		EXPECT_EQ(detail::longestCoveredStretch(turned), detail::longestCoveredStretch(border));
	}
}

} // namespace
} // namespace developable::test
