// SPDX-License-Identifier: GPL-3.0-or-later
// angle_sum.h: the sum of the angles round one vertex from their cotangents.
#pragma once

#include "fan_angles.h"

#include <cmath>

namespace developable {

/// The angles of one fan.
class AngleSum {
public:
	/// Adds the angle with this cotangent.
	void add(double cotangent) {
		product_.add(cotangent, 1);
		// Thin triangles have large cotangents; the argument does not care for the modulus, and no bit of it
		// for a power of two.
		if (std::abs(product_.real) + std::abs(product_.imaginary) > 0x1p400) {
			product_.real *= 0x1p-600;
			product_.imaginary *= 0x1p-600;
		}
	}

	/// 2π minus the sum, exact to rounding of the difference itself near 0.
	double defect() const { return product_.defect(); }

private:
	detail::FanProduct<double> product_;
};

} // namespace developable
