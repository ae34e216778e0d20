// SPDX-License-Identifier: GPL-3.0-or-later
// cone_ramp.h: a developable band that covers itself when it is laid flat.
#pragma once

#include "support/shapes.h"

namespace developable::test {

/// A band on a cone, more than once round it: laid flat it goes round the cone's apex by about a full turn
/// and so much more, rad, from radius 1 to 1.5 or, where it drifts, a little farther out in the end.
inline TriangleMesh coneRamp(double more, double drift = 0, int columns = 61, int rows = 5) {
	return grid(columns, rows, [more, drift](double u, double v) -> Eigen::Vector3d {
		constexpr double sine = 0.7; // of the cone's angle
		const double radius = 1 + v / 2 + drift * u, turn = u * (2 * pi + more) / sine;
		return {sine * radius * std::cos(turn), sine * radius * std::sin(turn),
				std::sqrt(1 - sine * sine) * radius};
	});
}

} // namespace developable::test
