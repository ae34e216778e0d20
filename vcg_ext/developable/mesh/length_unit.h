// SPDX-License-Identifier: GPL-3.0-or-later
// length_unit.h: lengths far from 1 in a unit in which their squares and cubes are numbers.
//
// A mesh of 1e-160 or of 1e80 is worked on as if a unit of its size had been chosen: readTriangles multiplies
// coordinates by a power of two, which changes no bit of their digits, and what is written or reported is
// multiplied back. Meshes of ordinary size have the exponent 0; others an even one, so that square roots of
// lengths have the same digits, too.
#pragma once

#include "triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace developable {

/// The exponent k for which coordinates times 2^-k are best worked with: that of the longest side of the box
/// round the vertices of triangles, or one more, so that it is even; 0 where that side is between 2^-64 and
/// 2^64, zero or infinite.
int lengthExponent(const Positions& positions, const Eigen::Matrix3Xi& triangles);

/// A quantity in the mesh's own unit.
/// \param lengthExponent  of the mesh it was worked out on
/// \param lengthPower     1 for a length, 2 for an area, -1 for a curvature
/// \return                the nearest finite number where it is beyond all
inline double inMeshUnits(int lengthExponent, double value, int lengthPower = 1) {
	constexpr double most = std::numeric_limits<double>::max();
	return std::clamp(std::ldexp(value, lengthPower * lengthExponent), -most, most);
}

/// The same of many quantities, in any shape.
template <class Values>
typename Values::PlainObject inMeshUnits(int lengthExponent, const Eigen::DenseBase<Values>& values,
										 int lengthPower = 1) {
	if (lengthExponent == 0)
		return values;
	return values.derived().unaryExpr(
		[=](double value) { return inMeshUnits(lengthExponent, value, lengthPower); });
}

/// A length that was given in the mesh's own unit.
inline double inWorkingUnits(int lengthExponent, double length) {
	return std::ldexp(length, -lengthExponent);
}

/// The nearest number that a type has, which is finite: what is too large for float becomes its largest.
template <class Scalar>
Scalar narrowed(double value) {
	constexpr auto most = static_cast<double>(std::numeric_limits<Scalar>::max());
	return static_cast<Scalar>(std::clamp(value, -most, most));
}

/// Coordinates as a mesh with that scalar holds them.
/// \param lengthExponent  of the mesh that they are to be written to
template <class Scalar, class Coordinates>
typename Coordinates::PlainObject rounded(const Eigen::DenseBase<Coordinates>& coordinates,
										  int lengthExponent = 0) {
	return coordinates.derived().unaryExpr([=](double x) {
		return inWorkingUnits(lengthExponent, double(narrowed<Scalar>(inMeshUnits(lengthExponent, x))));
	});
}

} // namespace developable
