// SPDX-License-Identifier: GPL-3.0-or-later
// rods.h: borders, seams and creases as thin rods that stay smooth where they are smooth.
#pragma once

#include "developable/mesh/mesh.h"

#include <array>
#include <vector>

namespace developable::detail {

/// Where a curve goes through a place: the places before, at and after it.
using RodJoint = std::array<int, 3>;

/// What of the edges of patches is a rod.
struct RodRules {
	double corner = 30; ///< degrees: where a curve turns by more it has a corner, which is no joint
	double crease = 40; ///< degrees: an inner edge whose triangles are folded by more is a crease
};

/// The joints of all borders, seams and creases of the original shape. Where several meet, those two go on
/// into one another that turn least, then the next.
std::vector<RodJoint> rodJoints(const PatchAssembly& assembly, const RodRules& rules);

/// The slope's change at a joint divided by the root of the length that it stands for: its squares add up to
/// ∫|d''|² ds. \return  the coefficients of d before, at and after the joint, length^-3/2
Eigen::Vector3d rodBending(const PatchAssembly& assembly, const RodJoint& joint);

/// The angle by which a curve turns at a joint, rad.
double turnAt(const RodJoint& joint, const Positions& positions);

/// Per place, the area of the part that it belongs to: of all patches that hang together by places.
Eigen::VectorXd partAreas(const PatchAssembly& assembly, const Eigen::VectorXd& triangleAreas);

} // namespace developable::detail
