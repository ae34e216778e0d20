// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_newton.h: the nearest developable shape: g = 0 in every patch, at minimum deformation (Eq. 6).
#pragma once

#include "assemble_patches.h"
#include "detail/resting_patches.h"

namespace developable {

struct ConstrainedNewtonOptions {
	double curvatureTolerance = 1e-4; ///< total absolute curvature of a patch that counts as developable, rad
	double angleTolerance = 1e-4;     ///< greatest angle defect of a developable point, rad
	int maxIterations = 200;          ///< steps on each level, each with one linear system
	/// Weight α of bending against distance, without unit (see detail::BendingMetric). Larger: fewer
	/// wrinkles, and the surface moves more.
	double smoothness = 3e-6;
	/// Bytes that the factor of a linear system may take; more is solved by iteration. 0: what the machine
	/// has.
	double memoryLimit = 0;
};

struct ConstrainedNewtonReport : OptimizationReport {
	/// Total absolute curvature that each patch is left with, rad, in double precision.
	std::vector<double> patchCurvature;
	int worstPatch = 0;    ///< the patch with most of it left
	int worstCopy = 0;     ///< the copy of that patch with the largest absolute angle defect
	double smoothness = 0; ///< the largest α that a patch was given; more than asked for where that failed
};

namespace detail {

inline void requireValid(const ConstrainedNewtonOptions& options) {
	const auto require = [](bool valid, const std::string& what) {
		if (!valid)
			throw InvalidParameter(what);
	};
	require(options.curvatureTolerance > 0, "The curvature tolerance must be greater than 0.");
	require(options.angleTolerance > 0, "The angle tolerance must be greater than 0.");
	require(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	require(options.smoothness > 0 && options.smoothness <= 1,
			"The smoothness must be greater than 0 and at most 1.");
	require(options.memoryLimit >= 0, "The limit of memory must not be negative.");
}

/// What of the report is read off the shape.
inline void describeShape(const PatchAssembly& assembly, const Eigen::VectorXd& defects,
						  ConstrainedNewtonReport& report) {
	const Eigen::ArrayXd curvatures = patchCurvatures(assembly, defects);
	report.patchCurvature.assign(curvatures.begin(), curvatures.end());
	curvatures.maxCoeff(&report.worstPatch);
	double worst = -1;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.patchOfCopy[copy] == report.worstPatch && std::abs(defects[copy]) > worst) {
			worst = std::abs(defects[copy]);
			report.worstCopy = copy;
		}
}

/// How many patches need a cut, and where.
inline void describeNeedOfCut(const PatchAssembly& assembly, const Positions& positions,
							  const CurvatureGoal& goal, ConstrainedNewtonReport& report) {
	const auto unmet = goal.unmetPatches(assembly, angleDefects(assembly, positions));
	const Eigen::Vector3d at = positions.col(assembly.placeOfCopy[report.worstCopy]);
	report.reason = Reason::NeedsCut;
	report.patchesNeedingCut = static_cast<int>(unmet.count());
	report.worstPosition = {at[0], at[1], at[2]};
}

} // namespace detail

/// Moves the places to the nearest shape found in which every patch is developable: C of each patch is at
/// most the curvature tolerance and no angle defect above the angle tolerance. No triangle is flipped and
/// none becomes a sliver (see detail::Soundness). Where that leads nowhere, triangles that are in the way are
/// made stiffer, and patches then tried again with 4, 16 and 64 times the smoothness; patches that need a cut
/// do not hold up the others.
///
/// \param positions  3 x places: where to start, and the result; untouched when stopped. Distance is measured
///                   from the assembly's original positions.
/// \return           Converged; NothingToDo; NeedsCut: some patches have no developable shape near;
///                   Stalled: places that are held still stand in the way; LimitReached; Stopped. When not
///                   converged, the result is the soundest near shape found, with less G than at the start.
/// \throws ClosedPatch, NothingFree, InvalidParameter
inline ConstrainedNewtonReport constrainedNewton(const PatchAssembly& assembly, Positions& positions,
												 const ConstrainedNewtonOptions& options,
												 const Progress& progress = {}) {
	detail::requireValid(options);
	requireOpenPatches(assembly);
	requireFreePlaces(assembly);
	const detail::CurvatureGoal goal{options.curvatureTolerance, options.angleTolerance};
	ConstrainedNewtonReport report;
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	if (!goal.unmetPatches(assembly, defects).any()) {
		detail::describeShape(assembly, defects, report);
		return report;
	}
	const detail::MultilevelNewton solver(options.smoothness, goal, options.maxIterations,
										  options.memoryLimit);
	detail::NewtonOutcome outcome = solver.solve(assembly, positions, progress);
	if (outcome.status != Status::Stopped &&
		!detail::better(assembly, angleDefects(assembly, outcome.positions), defects))
		outcome.positions = positions;
	if (outcome.status == Status::Stalled && !detail::holdsPlaces(assembly)) {
		outcome.status = Status::NeedsCut;
		outcome = detail::RestingPatches(assembly, positions, solver, goal, progress).finishOthers(outcome);
	}
	report.status = outcome.status;
	report.iterations = outcome.iterations;
	report.smoothness = outcome.smoothness;
	if (outcome.status == Status::Stopped)
		return report;
	positions = outcome.positions;
	detail::describeShape(assembly, angleDefects(assembly, positions), report);
	if (report.status == Status::NeedsCut)
		detail::describeNeedOfCut(assembly, positions, goal, report);
	return report;
}

} // namespace developable
