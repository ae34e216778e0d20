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

TEST(WorkBudget, GivesBackWhatIsReleased) {
	detail::WorkBudget budget(10);
	const detail::WorkReserve outer(budget, 0.2);
	{
		detail::WorkReserve inner(budget, 0.5);
		EXPECT_EQ(budget.left(), 4);
		inner.release();
		EXPECT_EQ(budget.left(), 8);
	}
	EXPECT_EQ(budget.left(), 8);
}

TEST(WorkBudget, WithoutLimitIsNeverSpent) {
	detail::WorkBudget budget;
	const detail::WorkReserve reserve(budget, 0.5);
	budget.spend(1e300);
	EXPECT_FALSE(budget.spent());
}

TEST(WorkBudget, AllowsSoManyTimesTheRestForWhatIsOnlyPreferred) {
	detail::WorkBudget budget;
	budget.spend(10);
	{
		const detail::ExtraWork extra(budget, 2);
		budget.spend(19);
		EXPECT_FALSE(budget.spent());
		budget.spendOperations(1e6);
		EXPECT_TRUE(budget.spent());
		EXPECT_TRUE(budget.extraSpent());
	}
	EXPECT_FALSE(budget.spent());
	EXPECT_EQ(budget.usedForTheRest(), 10);
	EXPECT_TRUE((detail::ExtraWork(budget, 2), budget.spent())); // none is left
	budget.spend(budget.extraUsed() / 2);
	const detail::ExtraWork extra(budget, 2);
	budget.spend(19);
	EXPECT_FALSE(budget.spent());
	budget.spend(2);
	EXPECT_TRUE(budget.spent());
}

TEST(WorkBudget, HasNoMoreExtraWorkThanItIsGiven) {
	detail::WorkBudget budget(1000, 30);
	budget.spend(100);
	{
		const detail::ExtraWork extra(budget, 2);
		budget.spend(20);
		EXPECT_FALSE(budget.spent());
		budget.spend(10);
		EXPECT_TRUE(budget.spent());
	}
	EXPECT_EQ(budget.extraLeft(), 0);
	EXPECT_EQ(budget.left(), 870);
}

TEST(WorkBudget, CountsExtraWorkOnceThatIsWithinOther) {
	detail::WorkBudget budget;
	budget.spend(10);
	{
		const detail::ExtraWork outer(budget, 2);
		const detail::ExtraWork inner(budget, 100);
		budget.spend(15);
		EXPECT_FALSE(budget.spent());
		budget.spend(5);
		EXPECT_TRUE(budget.spent());
	}
	budget.spend(1);
	const detail::ExtraWork extra(budget, 2);
	budget.spend(1);
	EXPECT_FALSE(budget.spent());
	budget.spend(1);
	EXPECT_TRUE(budget.spent());
}

TEST(WorkBudget, MeasuresExtraWorkByWhatWasSpentSinceItsBegin) {
	detail::WorkBudget budget;
	budget.spend(1000);
	const detail::WorkBudget begin = budget;
	detail::WorkBudget other; // as on another thread
	other.spend(10);
	{
		const detail::ExtraWork extra(other, 2);
		other.spend(10);
	}
	budget.spend(other);
	EXPECT_EQ(budget.used(), 1020);
	const detail::ExtraWork extra(budget, 2, begin);
	budget.spend(9);
	EXPECT_FALSE(budget.spent());
	budget.spend(1);
	EXPECT_TRUE(budget.spent());
}

} // namespace
} // namespace developable::test
