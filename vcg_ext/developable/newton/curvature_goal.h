// SPDX-License-Identifier: GPL-3.0-or-later
// curvature_goal.h: what the constrained Newton method has to reach, and how its parts say where they ended.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

#include <cmath>
#include <cstdio>

namespace developable::detail {

/// C of each patch, rad.
Eigen::ArrayXd patchCurvatures(const PatchAssembly& assembly, const Eigen::VectorXd& defects);

/// When a patch counts as developable.
struct CurvatureGoal {
	double curvatureTolerance, angleTolerance;

	/// Per patch, whether it is not there yet.
	Eigen::Array<bool, Eigen::Dynamic, 1> unmetPatches(const PatchAssembly& assembly,
													   const Eigen::VectorXd& defects) const;

	/// How far the curvature has come on its way down to the tolerance, 0 to 1: each tenth of it counts
	/// alike.
	double shareRemoved(double startCurvature, double curvature) const;
};

/// How far a place may go, as a share of the object's diagonal, in a shape that is developable and in one
/// that is not: further away it is not a shape near the original any more.
inline constexpr double farthestShareReached = 0.22, farthestShare = 0.2;

/// Whether some places may not move.
bool holdsPlaces(const PatchAssembly& assembly);

/// Whether a shape is better than another: less than a share of its G, and less C too unless places are held,
/// for then the goal is the least squares of g.
bool better(const PatchAssembly& assembly, const Eigen::VectorXd& defects, const Eigen::VectorXd& others,
			double share = 1);

/// How far the farthest place is from where it was.
double farthestDisplacement(const PatchAssembly& assembly, const Positions& positions);

/// How one level of the method, or a part of it, ended.
struct NewtonOutcome {
	Status status = Status::Stalled;
	int iterations = 0; ///< on this level
	Positions positions;
	double smoothness = 0; ///< the largest α that a patch was given
	bool farOff = false;   ///< it led to a developable shape, but not to one near the original
};

/// What of the total absolute curvature is gone after some steps, in words.
std::string describeCurvature(double start, double left, int steps);

} // namespace developable::detail
