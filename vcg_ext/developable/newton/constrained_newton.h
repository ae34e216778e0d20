// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_newton.h: the nearest developable shape: g = 0 in every patch, at minimum deformation (Eq. 6).
#pragma once

#include "coarser_level.h"
#include "developable/mesh/mesh.h"
#include "displacement_metric.h"
#include "newton_tuning.h"
#include "without_detail.h"

namespace developable {

struct ConstrainedNewtonOptions {
	double curvatureTolerance = 1e-4; ///< total absolute curvature of a patch that counts as developable, rad
	double angleTolerance = 1e-4;     ///< greatest angle defect of a developable point, rad
	int maxIterations = 200;          ///< steps on each level, each with one linear system
	/// Weight α of bending against distance, without unit (see detail::BendingMetric). Larger: fewer
	/// wrinkles, and the surface moves more.
	double smoothness = 3e-6;
	/// How much the shape's own bending counts, 0 to 1: bumps shorter than this share of the root of their
	/// part's area are smoothed away. 0: the surface keeps its own detail.
	double fairness = 0;
	/// How far a place of the result may be from where it was originally, length; negative: 15 % of the
	/// diagonal of its part.
	double maxDisplacement = -1;
	/// Bytes that the factor of a linear system may take; more is solved by iteration. 0: what the machine
	/// has.
	double memoryLimit = 0;
	int threads = 0;     ///< on which parts are solved side by side; 0: as many as can work at once
	NewtonTuning tuning; ///< constants of the method, for experiments
};

struct ConstrainedNewtonReport : OptimizationReport {
	/// Total absolute curvature that each patch is left with, rad, in double precision.
	std::vector<double> patchCurvature;
	/// What it took, in units of detail::WorkBudget: in proportion to the time, and yet the same on every
	/// machine, for it is counted.
	double work = 0;
	int worstPatch = 0; ///< the patch with most of it left, or whose border overlaps itself most
	int worstCopy = 0;  ///< the copy of that patch with the largest absolute angle defect, or where that is
};

/// Moves the places to the nearest shape found in which every patch is developable: C of each patch is at
/// most the curvature tolerance and no angle defect above the angle tolerance. No place goes farther than
/// the largest displacement, not by a bit, whatever the result. No triangle is flipped and
/// none becomes a sliver (see detail::Soundness). Where that leads nowhere, triangles that are in the way are
/// made stiffer; patches that need a cut do not hold up the others. Parts (see partsOf) are solved each by
/// itself, side by side; the result is the same to the last bit on any number of threads, and that of a part
/// in any company.
///
/// \param positions  3 x places: where to start, and the result; untouched when stopped. Distance is measured
///                   from the assembly's original positions.
/// \return           Converged; NothingToDo; NeedsCut: some patches have no developable shape near;
///                   Stalled: places that are held still stand in the way, or a linear system can't be solved
///                   in double precision; LimitReached; Stopped. When not converged, the result is the
///                   soundest near shape found, with less G than at the start.
///                   Of several parts the worst tells.
/// \throws ClosedPatch, NothingFree, InvalidParameter
ConstrainedNewtonReport constrainedNewton(const PatchAssembly& assembly, Positions& positions,
										  const ConstrainedNewtonOptions& options,
										  const Progress& progress = {});

} // namespace developable
