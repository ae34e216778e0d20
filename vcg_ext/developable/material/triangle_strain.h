// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_strain.h: the linear map of a triangle from the flat pattern to the shape, and its strains.
#pragma once

#include <Eigen/Core>

namespace developable {

/// F, the map that takes a triangle of the pattern to that of the shape, 3 x 2, by its singular values.
struct TriangleStrain {
	Eigen::Matrix<double, 3, 2> map = Eigen::Matrix<double, 3, 2>::Zero();
	Eigen::Matrix2d inverseFlatEdges = Eigen::Matrix2d::Zero();
	double flatArea = 0;                        ///< doubled, signed
	double greatest = 0;                        ///< σ1
	double least = 0;                           ///< σ2 ≤ σ1
	Eigen::Vector2d greatestDirection = {1, 0}; ///< in the plane, unit length; that of σ2 is normal to it

	/// \param shaped  the corners of the triangle of the shape, one in each column
	/// \param flat    those of the pattern; must have an area
	TriangleStrain(const Eigen::Matrix3d& shaped, const Eigen::Matrix<double, 2, 3>& flat);

	double stretch() const { return greatest - 1; }
	double compression() const { return 1 - least; }
};

} // namespace developable
