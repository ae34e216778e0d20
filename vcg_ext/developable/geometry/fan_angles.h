// SPDX-License-Identifier: GPL-3.0-or-later
// fan_angles.h: the sum of the angles round a vertex from their cotangents, with one arctangent for a fan.
#pragma once

#include "developable/mesh/mesh.h"
#include "wide.h"

namespace developable::detail {

/// arctan t for |t| <= tan(π/16) to 4e-17 t: t + t z P(z) with z = t², P of degree 6 through the function's
/// values at the Chebyshev points.
template <class Number>
DEVELOPABLE_INLINE Number smallArctangent(const Number& t) {
	constexpr double coefficients[] = {-0.33333333333333237, 0.1999999999976099,   -0.14285714188882723,
									   0.11111096372965647,  -0.09089837900709528, 0.07652130942243261,
									   -0.05909857213116147};
	const Number z = t * t;
	Number sum = every<Number>(coefficients[6]);
	for (int i = 5; i >= 0; --i)
		sum = sum * z + coefficients[i];
	return t + t * (z * sum);
}

/// The argument of a complex number, rad, as std::atan2 gives it, without branches. Not a number at 0.
template <class Number>
DEVELOPABLE_INLINE Number argument(const Number& real, const Number& imaginary) {
	constexpr double tangent1 = 0.198912367379658, tangent2 = 0.41421356237309503,
					 tangent3 = 0.6681786379192989; // of π/16, π/8 and 3π/16
	const Number x = absolute(real), y = absolute(imaginary);
	const Number less = x < y ? x : y, more = x < y ? y : x;
	// From less/more, the tangent of an angle between 0 and π/4, the nearest of 0, π/8 and π/4 is taken away.
	const auto atLeastOne = less > tangent1 * more, two = less > tangent3 * more;
	const Number tangent =
		(atLeastOne ? every<Number>(tangent2) : Number{}) + (two ? every<Number>(1 - tangent2) : Number{});
	const Number taken =
		(atLeastOne ? every<Number>(pi / 8) : Number{}) + (two ? every<Number>(pi / 8) : Number{});
	Number angle = taken + smallArctangent<Number>((less - tangent * more) / (more + tangent * less));
	angle = absolute<Number>((x < y ? every<Number>(pi / 2) : Number{}) - angle);
	angle = absolute<Number>((real < 0 ? every<Number>(pi) : Number{}) - angle);
	return withSignsOf(imaginary, angle);
}

/// The angles of a fan as the argument of a product of complex numbers, so that one arctangent serves the
/// whole fan. Each angle lies between 0 and π, so the sum begins a new turn where the imaginary part falls
/// below 0: turns are counted, and nothing is lost beyond 2π.
template <class Number>
struct FanProduct {
	Number real = Number{} + 1, imaginary{}, turns{};

	/// Adds the angle with this cosine and sine, or any positive multiple of both.
	DEVELOPABLE_INLINE void add(const Number& cosine, const Number& sine) {
		const Number before = imaginary;
		imaginary = real * sine + before * cosine;
		real = real * cosine - before * sine;
		turns += ((before >= 0) & (imaginary < 0)) ? every<Number>(1) : Number{};
	}

	/// 2π minus the sum, exact to rounding of the difference itself near 0. A sum of π may leave an imaginary
	/// part of −0, which is not below 0, so that no turn is counted, but has the argument −π: adding 0 makes
	/// it +0.
	DEVELOPABLE_INLINE Number defect() const {
		return 2 * pi * (1 - turns) - argument<Number>(real, imaginary + 0.0);
	}
};

} // namespace developable::detail
