// SPDX-License-Identifier: GPL-3.0-or-later
// area_hessian.cpp: in the plane of both equilateral parts of the gradient two eigenvalues are left to find.
#include "area_hessian.h"

#include "developable/geometry/geometry.h"

#include <cmath>
#include <complex>

namespace developable::detail {

namespace {

using Complex = std::complex<double>;

const double root3 = std::sqrt(3);

/// A triangle that is equilateral, round one way or the other.
struct Equilateral {
	AreaGradient along;  ///< a unit vector
	AreaGradient across; ///< the same, turned by 90°
	double length = 0;
};

/// The part of a gradient that is.
/// \param turn  1: counter-clockwise, eigenvalue √3; −1: clockwise, −√3
Equilateral partOf(const AreaGradient& area, int turn) {
	const Complex third(-0.5, turn * root3 / 2); // of a full turn
	Complex first = 0, power = 1;
	for (int corner = 0; corner < 3; ++corner, power *= third)
		first += Complex(area[2 * corner], area[2 * corner + 1]) * std::conj(power) / 3.0;
	const double size = std::abs(first);
	Equilateral part;
	part.length = root3 * size;
	power = (size > 0 ? first / size : Complex(1)) / root3;
	for (int corner = 0; corner < 3; ++corner, power *= third) {
		part.along.segment<2>(2 * corner) << power.real(), power.imag();
		part.across.segment<2>(2 * corner) << -power.imag(), power.real();
	}
	return part;
}

/// The nearest positive semidefinite matrix to one of two rows whose trace is not negative.
Eigen::Matrix2d convex(const Eigen::Matrix2d& matrix) {
	const double mean = matrix.trace() / 2;
	const Eigen::Matrix2d deviator = matrix - mean * Eigen::Matrix2d::Identity();
	const double radius = std::hypot(deviator(0, 0), deviator(0, 1));
	if (radius <= mean)
		return matrix;
	return (mean + radius) / 2 * (Eigen::Matrix2d::Identity() + deviator / radius);
}

} // namespace

AreaHessian areaHessian(const AreaGradient& area, double slope, double curvature) {
	AreaHessian hessian = curvature * area * area.transpose();
	for (int corner = 0; corner < 3; ++corner) {
		const int a = 2 * corner, b = 2 * nextCorner(corner);
		for (const auto& [row, column, sign] : {std::tuple{a, b + 1, 1}, std::tuple{a + 1, b, -1}}) {
			hessian(row, column) += sign * slope;
			hessian(column, row) += sign * slope;
		}
	}
	return hessian;
}

AreaHessian convexAreaHessian(const AreaGradient& area, double slope, double curvature) {
	const Equilateral plus = partOf(area, 1), minus = partOf(area, -1);
	Eigen::Matrix<double, 6, 2> plane;
	plane << plus.along, minus.along;
	const Eigen::Vector2d gradient(plus.length, minus.length);
	Eigen::Matrix2d inPlane = curvature * gradient * gradient.transpose();
	inPlane(0, 0) += root3 * slope;
	inPlane(1, 1) -= root3 * slope;
	return plane * convex(inPlane) * plane.transpose() -
		   root3 * slope * minus.across * minus.across.transpose();
}

} // namespace developable::detail
