// SPDX-License-Identifier: GPL-3.0-or-later
// second_derivatives.h: second derivatives on a surface as linear functions of values at the places.
#pragma once

#include "developable/mesh/mesh.h"

#include <vector>

namespace developable {

/// The second derivatives of a function at one vertex copy, along its tangent plane.
struct SecondDerivatives {
	std::vector<int> places;
	/// 3 x places: these rows times the values there are f_xx, √2 f_xy and f_yy, 1 / length². Of the
	/// positions themselves these are, for the surface that they were taken from, the curvatures times the
	/// normal.
	Eigen::Matrix3Xd rows;
};

/// Of every copy, from the quadric over its tangent plane that fits its neighbours and theirs best, as
/// principalCurvatures has it; no places where there are too few.
std::vector<SecondDerivatives> secondDerivatives(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
