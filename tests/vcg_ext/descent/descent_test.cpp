// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/descent/descent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace developable::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(DescendsEnough, AsksForATenThousandthOfWhatTheSlopePromises) {
	for (const double length : {0.01, 1.0, 100.0}) {
		EXPECT_TRUE(descendsEnough(0, -2, length, -1e-4 * 2 * length));
		EXPECT_TRUE(descendsEnough(0, -2, length, -2 * length));
		EXPECT_FALSE(descendsEnough(0, -2, length, -0.99e-4 * 2 * length));
	}
	EXPECT_TRUE(descendsEnough(7, -1, 1, 6.9));
	EXPECT_FALSE(descendsEnough(7, -1, 1, 7.1));
}

TEST(DescendsEnough, ValuesThatAreNotNumbersAreTooHigh) {
	EXPECT_FALSE(descendsEnough(1, -1, 1, nan));
	EXPECT_FALSE(descendsEnough(1, -1, 1, std::numeric_limits<double>::infinity()));
	EXPECT_FALSE(descendsEnough(nan, -1, 1, 0));
}

TEST(DescendsEnough, EqualityIsNotEnough) {
	EXPECT_FALSE(descendsEnough(1, -1e-30, 1, 1)); // though 1 - 1e-34 is 1
	EXPECT_FALSE(descendsEnough(1, 0, 1, 1));
}

TEST(DescendsEnough, AnyLowerValueIsEnoughWithoutASlope) {
	EXPECT_TRUE(descendsEnough(1, 0, 1, std::nextafter(1.0, 0.0)));
	EXPECT_FALSE(descendsEnough(1, 0, 1, std::nextafter(1.0, 2.0)));
}

TEST(ParabolaMinimum, IsThatOfAParabola) {
	const auto parabola = [](double t) { return 5 + 2 * (t - 3) * (t - 3); };
	for (const double length : {0.1, 3.0, 50.0})
		EXPECT_NEAR(parabolaMinimum(parabola(0), -12, length, parabola(length)), 3, 1e-12);
}

TEST(ParabolaMinimum, IsNotPositiveWhereItDoesNotOpenUpwards) {
	EXPECT_LE(parabolaMinimum(0, -1, 2, -3), 0); // downwards
	EXPECT_LE(parabolaMinimum(0, -1, 2, -2), 0); // straight
	EXPECT_LE(parabolaMinimum(0, -1, 2, nan), 0);
}

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

TEST(LineSearch, LengthItFindsDescendsEnough) {
	const auto steep = [](double t) { return std::exp(t) - 30 * t; }; // least at ln 30
	for (const double trial : {1e-3, 1.0, 40.0, 700.0}) {
		const double length = lineSearch(steep, 1, -29, trial);
		EXPECT_TRUE(descendsEnough(1, -29, length, steep(length))) << trial;
	}
}

TEST(LineSearch, GivesUpWhereNothingIsLower) {
	EXPECT_EQ(lineSearch([](double x) { return x * x; }, 0, -1e-30, 1), 0);
}

} // namespace
} // namespace developable::test
