// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_strain.cpp: the singular values of a 3 x 2 matrix, by those of its 2 x 2 Gram matrix.
#include "triangle_strain.h"

#include <cmath>

namespace developable {

namespace {

/// The direction at half the angle of (cosine, sine), with a first coordinate that is not negative. Without
/// the angle itself: this is worked out for every triangle, many times.
Eigen::Vector2d halfWayTo(double cosine, double sine) {
	const double length = std::sqrt(cosine * cosine + sine * sine);
	if (!(length > 0 && std::isfinite(length)))
		return {1, 0};
	const double larger = std::sqrt((length + std::abs(cosine)) / (2 * length)),
				 smaller = sine / (2 * length * larger);
	return cosine >= 0 ? Eigen::Vector2d(larger, smaller)
					   : Eigen::Vector2d(std::abs(smaller), std::copysign(larger, sine));
}

} // namespace

TriangleStrain::TriangleStrain(const Eigen::Matrix3d& shaped, const Eigen::Matrix<double, 2, 3>& flat) {
	Eigen::Matrix<double, 3, 2> shapedEdges;
	shapedEdges << shaped.col(1) - shaped.col(0), shaped.col(2) - shaped.col(0);
	const Eigen::Vector2d a = flat.col(1) - flat.col(0), b = flat.col(2) - flat.col(0);
	flatArea = a[0] * b[1] - a[1] * b[0];
	inverseFlatEdges << b[1], -b[0], -a[1], a[0];
	inverseFlatEdges /= flatArea;
	map = shapedEdges * inverseFlatEdges;
	// FᵀF = R diag(σ1², σ2²) Rᵀ, with R the rotation by half the angle of (difference, shear).
	const double difference = (map.col(0).squaredNorm() - map.col(1).squaredNorm()) / 2;
	const double shear = map.col(0).dot(map.col(1));
	greatestDirection = halfWayTo(difference, shear);
	const Eigen::Vector2d leastDirection(-greatestDirection[1], greatestDirection[0]);
	greatest = (map * greatestDirection).norm();
	least = (map * leastDirection).norm();
}

} // namespace developable
