// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/descent/descent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace developable::test {
namespace {

TEST(LineSearch, FindsTheMinimumOfAParabolaFromAnyTrial) {
	const auto parabola = [](double x) { return (x - 3) * (x - 3); };
	for (const double trial : {1e-6, 0.1, 2.9, 5.0, 1e6})
		EXPECT_NEAR(lineSearch(parabola, 9, -6, trial), 3, 1e-6) << trial;
}

TEST(LineSearch, StepsBackFromValuesThatAreNotNumbers) {
	const auto function = [](double x) { return x > 1 ? std::nan("") : -x; };
	const double length = lineSearch(function, 0, -1, 64);
	EXPECT_GT(length, 0.1);
	EXPECT_LE(length, 1);
}

TEST(LineSearch, GivesUpWhereNothingIsLower) {
	EXPECT_EQ(lineSearch([](double x) { return x * x; }, 0, -1e-30, 1), 0);
}

} // namespace
} // namespace developable::test
