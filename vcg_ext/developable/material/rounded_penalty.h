// SPDX-License-Identifier: GPL-3.0-or-later
// rounded_penalty.h: what it costs to be beyond a bound.
#pragma once

#include <cmath>

namespace developable {

/// p of an excess c, with p'(c) = κ/2 (c + √(c² + δ²)): the quadratic penalty κ/2 c₊² whose edge is rounded
/// over the width δ, so that Newton's method sees a bound coming. Convex.
struct RoundedPenalty {
	double stiffness = 1; ///< κ
	double width = 1e-3;  ///< δ, in the unit of c

	double value(double c) const {
		const double rounded = root(c), size = std::abs(c);
		const double areaOfEdge = std::copysign(std::log((size + rounded) / width), c); // arsinh c / δ
		return stiffness / 4 * (c * (c + rounded) + width * width * areaOfEdge);
	}
	double first(double c) const { return stiffness / 2 * (c + root(c)); }
	double second(double c) const { return stiffness / 2 * (1 + c / root(c)); }

private:
	double root(double c) const { return std::sqrt(c * c + width * width); }
};

} // namespace developable
