// SPDX-License-Identifier: GPL-3.0-or-later
// descent.h: the front door of descent/: how far to go along a direction that leads down.
#pragma once

#include <algorithm>

namespace developable {

/// Whether a step lowers a function enough for its length (Armijo 1966): by a ten-thousandth at least of what
/// the slope promises. Values that are not numbers count as too high.
/// \param slope  the derivative at length 0, negative
inline bool descendsEnough(double valueAtZero, double slope, double length, double value) {
	constexpr double sufficient = 1e-4;
	return value <= valueAtZero + sufficient * slope * length && value < valueAtZero;
}

/// Where the parabola through the value and slope at 0 and the value at a length has its least value; a
/// length that is not positive when it opens downwards.
inline double parabolaMinimum(double valueAtZero, double slope, double length, double value) {
	const double curvature = value - valueAtZero - slope * length;
	return curvature > 0 ? -slope * length * length / (2 * curvature) : 0;
}

/// A length at which the function is lower than at 0 by Armijo's measure, near its least value along the
/// line: the first trial is doubled as long as that pays, or shortened until it does, and a parabola does the
/// rest. Values that are not numbers count as too high.
///
/// \param function  of the length
/// \param slope     its derivative at 0, negative
/// \return          0 when no length was found
template <class Function>
double lineSearch(const Function& function, double valueAtZero, double slope, double trial) {
	constexpr int mostTrials = 60;
	const auto lowEnough = [&](double length, double value) {
		return descendsEnough(valueAtZero, slope, length, value);
	};
	double length = trial, value = function(length);
	if (lowEnough(length, value)) {
		for (int i = 0; i < mostTrials; ++i) {
			const double doubled = function(2 * length);
			if (!(doubled < value))
				break;
			length *= 2;
			value = doubled;
		}
	} else {
		for (int i = 0; !lowEnough(length, value); ++i) {
			if (i == mostTrials)
				return 0;
			const double guess = parabolaMinimum(valueAtZero, slope, length, value);
			length = guess > 0 ? std::clamp(guess, 0.1 * length, 0.5 * length) : 0.5 * length;
			value = function(length);
		}
	}
	const double refined = parabolaMinimum(valueAtZero, slope, length, value);
	if (refined > 0 && refined < 2 * length && function(refined) < value)
		return refined;
	return length;
}

} // namespace developable
