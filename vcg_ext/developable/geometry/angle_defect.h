// SPDX-License-Identifier: GPL-3.0-or-later
// angle_defect.h: the angle defect g, its gradient, and what is summed from it (Sections 3.2, 3.3).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The cotangents of all corners, 3 x triangles.
Eigen::Matrix3Xd cornerCotangents(const PatchAssembly& assembly, const Positions& positions);

/// Angle defect of every vertex copy (Eq. 5): 2π minus its corner angles inside a patch, 0 on the boundary.
/// \param positions  3 x places, any unit of length
/// \return           per copy, rad; not a number where a triangle has no area
Eigen::VectorXd angleDefects(const PatchAssembly& assembly, const Positions& positions);

/// The angles of a patch at every copy on its boundary, added up, rad; 0 inside.
Eigen::VectorXd borderAngles(const PatchAssembly& assembly, const Positions& positions);

/// What keeps the patches from lying flat: the angle defects inside, and on the boundary 2π minus the angles
/// where these add up to more than 2π, for there a patch would overlap itself; rad.
Eigen::VectorXd flatDefects(const PatchAssembly& assembly, const Positions& positions);

/// The detect function G = Σ g² (Eq. 4), rad².
double detectFunction(const Eigen::VectorXd& defects);

/// C = Σ abs(g), rad.
double totalAbsoluteCurvature(const Eigen::VectorXd& defects);

/// The largest abs(g), rad; 0 of none, and not a number where any of them is not.
double largestAngleDefect(const Eigen::VectorXd& defects);

/// The gradient of Σ weight · g over all copies with respect to the places, in closed form; linked copies add
/// up (Eq. 14). With weight = 2g it is the gradient of G.
/// \param weights  per copy; those of copies on a boundary must be 0
/// \return         3 x places, rad/length times the weights' unit
Positions weightedDefectGradient(const PatchAssembly& assembly, const Positions& positions,
								 const Eigen::VectorXd& weights);

/// The gradient of the detect function G (Eq. 14) in closed form, 3 x places, rad²/length.
Positions detectFunctionGradient(const PatchAssembly& assembly, const Positions& positions,
								 const Eigen::VectorXd& defects);

/// A third of the area of the triangles round each copy (Eq. 1 and 2), length².
Eigen::VectorXd copyAreas(const PatchAssembly& assembly, const Positions& positions);

/// Discrete Gaussian curvature κ of every copy (Eq. 1), 1/length².
Eigen::VectorXd gaussianCurvatures(const PatchAssembly& assembly, const Positions& positions);

/// How developable a shape is.
struct Measures {
	double developability = 1;         ///< D (Eq. 2): share of area held by developable points, 0 to 1
	double detectFunction = 0;         ///< G (Eq. 4), rad²
	double maxAngleDefect = 0;         ///< largest absolute g, rad
	double totalAbsoluteCurvature = 0; ///< C = Σ abs(g), rad
};

/// Measures a shape. A copy with an angle defect of at most angleTolerance (rad) is a developable point.
Measures measure(const PatchAssembly& assembly, const Positions& positions, double angleTolerance);

} // namespace developable
