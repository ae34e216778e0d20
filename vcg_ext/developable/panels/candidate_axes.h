// SPDX-License-Identifier: GPL-3.0-or-later
// candidate_axes.h: axes that a surface has by its shape alone.
#pragma once

#include "developable/mesh/mesh.h"

#include <vector>

namespace developable::detail {

/// Of a surface with area as its mass.
struct AreaMoments {
	Eigen::Vector3d centre = Eigen::Vector3d::Zero();
	Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< about the centre, by unit of area, length²

	double radius() const { return std::sqrt(covariance.trace()); } ///< of gyration, length
};

AreaMoments areaMoments(const TriangleMesh& mesh);

/// Rotations that bring a surface to axes of its own: to its principal axes, both ways along each, where
/// these are distinct; else to axes through vertices that are unlike most others, which a turned copy of the
/// surface has, too. Any of them is as good as any other. Only the identity where there are more than can be
/// compared.
/// \param mesh  about its centre, with a radius of gyration of 1
std::vector<Eigen::Matrix3d> candidateAxes(const TriangleMesh& mesh, const Eigen::Matrix3d& covariance);

} // namespace developable::detail
