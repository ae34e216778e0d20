// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest box round points that are turned.
#include "developable/panels/smallest_box.h"

#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(SmallestBox, isThatOfABoxHoweverItIsTurned) {
	Positions corners(3, 8);
	for (int corner = 0; corner < 8; ++corner)
		corners.col(corner) << (corner & 1) * 3, (corner & 2) / 2 * 2, (corner & 4) / 4;
	for (const Eigen::Quaterniond& turn :
		 {Eigen::Quaterniond(1, 0, 0, 0), Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4),
		  Eigen::Quaterniond(-0.6, 0.2, 0.1, 0.9)}) {
		const Positions turned = turn.normalized().toRotationMatrix() * corners;
		EXPECT_NEAR(detail::smallestBoxDiagonal(turned), std::sqrt(14.0), 0.002);
	}
}

TEST(SmallestBox, isNeverMoreThanTheOneAlongTheAxes) {
	const Positions points = sphere(1, 3).positions;
	EXPECT_LE(detail::smallestBoxDiagonal(points), boxDiagonal(points));
	EXPECT_NEAR(detail::smallestBoxDiagonal(points), 2 * std::sqrt(3.0), 0.05);
}

} // namespace
} // namespace developable::test
