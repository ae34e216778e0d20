// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_strain.cpp: the singular values of a 3 x 2 matrix, by those of its 2 x 2 Gram matrix.
#include "triangle_strain.h"

#include <cmath>

namespace developable {

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
	const double angle = std::atan2(shear, difference) / 2;
	greatestDirection << std::cos(angle), std::sin(angle);
	const Eigen::Vector2d leastDirection(-greatestDirection[1], greatestDirection[0]);
	greatest = (map * greatestDirection).norm();
	least = (map * leastDirection).norm();
}

} // namespace developable
