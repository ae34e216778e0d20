// SPDX-License-Identifier: GPL-3.0-or-later
// curvature_goal.h: what the constrained Newton method has to reach, and how its parts say where they ended.
#pragma once

#include "../angle_defect.h"
#include "../progress.h"
#include "../report.h"

#include <cmath>
#include <cstdio>

namespace developable::detail {

/// C of each patch, rad.
inline Eigen::ArrayXd patchCurvatures(const PatchAssembly& assembly, const Eigen::VectorXd& defects) {
	Eigen::ArrayXd curvatures = Eigen::ArrayXd::Zero(assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		curvatures[assembly.patchOfCopy[copy]] += std::abs(defects[copy]);
	return curvatures;
}

/// When a patch counts as developable.
struct CurvatureGoal {
	double curvatureTolerance, angleTolerance;

	/// Per patch, whether it is not there yet.
	Eigen::Array<bool, Eigen::Dynamic, 1> unmetPatches(const PatchAssembly& assembly,
													   const Eigen::VectorXd& defects) const {
		Eigen::ArrayXd greatest = Eigen::ArrayXd::Zero(assembly.patchCount());
		for (int copy = 0; copy < assembly.copyCount(); ++copy) {
			double& ofPatch = greatest[assembly.patchOfCopy[copy]];
			ofPatch = std::max(ofPatch, std::abs(defects[copy]));
		}
		return !(patchCurvatures(assembly, defects) <= curvatureTolerance && greatest <= angleTolerance);
	}

	/// How far the curvature has come on its way down to the tolerance, 0 to 1: each tenth of it counts
	/// alike.
	double shareRemoved(double startCurvature, double curvature) const {
		const double whole = std::log(startCurvature / curvatureTolerance);
		const double done = std::log(startCurvature / std::max(curvature, curvatureTolerance));
		return whole > 0 ? std::clamp(done / whole, 0.0, 1.0) : 0;
	}
};

/// How far a place may go, as a share of the object's diagonal, in a shape that is developable and in one
/// that is not: further away it is not a shape near the original any more.
inline constexpr double farthestShareReached = 0.22, farthestShare = 0.2;

/// Whether some places may not move.
inline bool holdsPlaces(const PatchAssembly& assembly) {
	return std::find(assembly.placeFixed.begin(), assembly.placeFixed.end(), 1) != assembly.placeFixed.end();
}

/// Whether a shape is better than another: less than a share of its G, and less C too unless places are held,
/// for then the goal is the least squares of g.
inline bool better(const PatchAssembly& assembly, const Eigen::VectorXd& defects,
				   const Eigen::VectorXd& others, double share = 1) {
	return detectFunction(defects) < share * detectFunction(others) &&
		   (holdsPlaces(assembly) || defects.cwiseAbs().sum() < others.cwiseAbs().sum());
}

/// How far the farthest place is from where it was.
inline double farthestDisplacement(const PatchAssembly& assembly, const Positions& positions) {
	return (positions - assembly.originalPositions).colwise().norm().maxCoeff();
}

/// How one level of the method, or a part of it, ended.
struct NewtonOutcome {
	Status status = Status::Stalled;
	int iterations = 0; ///< on this level
	Positions positions;
	double smoothness = 0; ///< the largest α that a patch was given
	bool farOff = false;   ///< it led to a developable shape, but not to one near the original
};

/// What of the total absolute curvature is gone after some steps, in words.
inline std::string describeCurvature(double start, double left, int steps) {
	char text[160];
	std::snprintf(text, sizeof text,
				  "%d steps: %.4g %% of the total absolute curvature removed, %.3g rad left", steps,
				  100 * (1 - left / start), left);
	return text;
}

} // namespace developable::detail
