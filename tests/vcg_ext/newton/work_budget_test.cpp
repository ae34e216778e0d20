// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/work_budget.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(WorkBudget, IsSpentWhenAllIsUsed) {
	detail::WorkBudget budget(10);
	budget.spend(6);
	EXPECT_FALSE(budget.spent());
	EXPECT_EQ(budget.left(), 4);
	budget.spendOperations(1e6);
	EXPECT_TRUE(budget.spent());
	EXPECT_GT(budget.used(), 10);
}

TEST(WorkBudget, KeepsAShareOfWhatIsLeftForLater) {
	detail::WorkBudget budget(10);
	budget.spend(2);
	{
		const detail::WorkReserve finer(budget, 0.5);
		EXPECT_EQ(budget.left(), 4);
		{
			const detail::WorkReserve free(budget, 0.25);
			EXPECT_EQ(budget.left(), 3);
			budget.spend(3);
			EXPECT_TRUE(budget.spent());
		}
		EXPECT_EQ(budget.left(), 1);
	}
	EXPECT_EQ(budget.left(), 5);
}

TEST(WorkBudget, WithoutLimitIsNeverSpent) {
	detail::WorkBudget budget;
	const detail::WorkReserve reserve(budget, 0.5);
	budget.spend(1e300);
	EXPECT_FALSE(budget.spent());
}

} // namespace
} // namespace developable::test
