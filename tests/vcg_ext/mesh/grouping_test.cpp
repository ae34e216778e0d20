// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/grouping.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace developable::test {
namespace {

std::vector<int> membersOf(const Groups& groups, int group) {
	return {groups.begin(group), groups.end(group)};
}

TEST(Grouping, IsThatOfANaiveOne) {
	std::mt19937 random(3);
	for (const int count : {1, 2, 17, 400}) {
		std::vector<int> groupOf(200);
		for (int& group : groupOf)
			group = static_cast<int>(random() % count); // of 400 groups many stay empty
		const Groups groups = grouped(count, 200, [&](int member) { return groupOf[member]; });
		ASSERT_EQ(groups.count(), count);
		for (int group = 0; group < count; ++group) {
			std::vector<int> expected; // in ascending order
			for (int member = 0; member < 200; ++member)
				if (groupOf[member] == group)
					expected.push_back(member);
			EXPECT_EQ(membersOf(groups, group), expected);
			EXPECT_EQ(groups.size(group), static_cast<int>(expected.size()));
		}
		EXPECT_EQ(groups.members.size(), groupOf.size());
	}
}

TEST(Grouping, EmptyGroupsAtBothEndsAndBetween) {
	const std::vector<int> groupOf = {3, 1, 3};
	const Groups groups = grouped(6, 3, [&](int member) { return groupOf[member]; });
	EXPECT_EQ(groups.start, (std::vector<int>{0, 0, 1, 1, 3, 3, 3}));
	EXPECT_EQ(groups.members, (std::vector<int>{1, 0, 2}));
	for (const int group : {0, 2, 4, 5})
		EXPECT_EQ(groups.begin(group), groups.end(group));
}

TEST(Grouping, OfNothing) {
	const auto nothing = [](int) -> int { throw std::logic_error("there are no members"); };
	EXPECT_EQ(grouped(0, 0, nothing).count(), 0);
	const Groups groups = grouped(3, 0, nothing);
	EXPECT_EQ(groups.count(), 3);
	EXPECT_EQ(groups.size(0) + groups.size(1) + groups.size(2), 0);
}

} // namespace
} // namespace developable::test
