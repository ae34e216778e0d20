// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace developable::test {
namespace {

TEST(BoxTree, FindsAllThatMeetABoxWhileTheyMove) {
	std::mt19937 random(2);
	const auto randomBox = [&](double size) {
		const auto share = [&] { return double(random()) / std::mt19937::max(); };
		const Eigen::Vector3d at(share(), share(), share());
		Eigen::Matrix3d points;
		for (auto point : points.colwise())
			point = at + size * Eigen::Vector3d(share(), share(), share());
		return boxOf(points);
	};
	for (const int count : {1, 8, 9, 700}) {
		std::vector<Box> boxes(count);
		for (Box& box : boxes)
			box = randomBox(0.1);
		BoxTree tree(boxes);
		for (int round = 0; round < 200; ++round) {
			const int mover = static_cast<int>(random() % count);
			boxes[mover] = randomBox(0.1);
			tree.extend(mover, boxes[mover]);
			const Box wanted = randomBox(0.3);
			const std::vector<int>& found = tree.near(wanted);
			for (int i = 0; i < count; ++i) {
				const bool meets = (boxes[i].head<3>() <= -wanted.tail<3>()).all() &&
								   (wanted.head<3>() <= -boxes[i].tail<3>()).all();
				EXPECT_EQ(contains(boxes[i], core(wanted)), meets);
				if (meets) {
					EXPECT_EQ(std::count(found.begin(), found.end(), i), 1);
				}
			}
			if (count == 700 && round == 0) {
				EXPECT_LT(found.size(), 100);
			}
		}
	}
}

} // namespace
} // namespace developable::test
