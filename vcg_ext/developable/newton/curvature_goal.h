// SPDX-License-Identifier: GPL-3.0-or-later
// curvature_goal.h: what the constrained Newton method has to reach, and which of two shapes is nearer to it.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

#include <limits>
#include <vector>

namespace developable::detail {

/// C of each patch, rad.
Eigen::ArrayXd patchCurvatures(const PatchAssembly& assembly, const Eigen::VectorXd& defects);

/// When a patch counts as developable, and how far from the original it may be.
struct CurvatureGoal {
	double curvatureTolerance, angleTolerance; ///< rad
	/// How far a place of the result may be from where it was, length.
	double farthest = std::numeric_limits<double>::infinity();

	/// Per patch, whether it is not there yet.
	Eigen::Array<bool, Eigen::Dynamic, 1> unmetPatches(const PatchAssembly& assembly,
													   const Eigen::VectorXd& defects) const;

	/// Whether every patch is there.
	bool reached(const PatchAssembly& assembly, const Eigen::VectorXd& defects) const {
		return !unmetPatches(assembly, defects).any();
	}

	/// Per patch whose curvature is gone, at how many vertices of its border the angles add up to more than a
	/// full turn, by more than the angle tolerance, but those of the worst count in any case; 0 of others.
	std::vector<int> borderOverlaps(const PatchAssembly& assembly, const Positions& positions) const;

	/// How far the curvature has come on its way down to the tolerance, 0 to 1: each tenth of it counts
	/// alike.
	double shareRemoved(double startCurvature, double curvature) const;
};

/// Whether a shape is better than another: less G, and less C too unless places are held, for then the goal
/// is the least squares of g.
bool better(const PatchAssembly& assembly, const Eigen::VectorXd& defects, const Eigen::VectorXd& others);

/// Whether it has less C, or less G where places are held.
bool lessCurved(const PatchAssembly& assembly, const Eigen::VectorXd& defects, const Eigen::VectorXd& others);

} // namespace developable::detail
