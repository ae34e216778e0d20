// SPDX-License-Identifier: GPL-3.0-or-later
// closer_shapes.h: from a developable shape to ones whose farthest place is nearer.
#pragma once

#include "attempts.h"
#include "constrained_newton.h"
#include "gauss_newton.h"

namespace developable::detail {

/// Lowers the bound on displacements below how far the farthest place is, by NewtonTuning::closerStep, and
/// restores within it; time and again, as long as that leads within the bound and places are hardly farther
/// on average, down to NewtonTuning::closerFrom of how far a place had better move.
/// \param run         at a developable shape; ends at the closest
/// \param nearEnough  length: no closer than that
/// \return            as the last restoration ended
Ending comeCloser(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double nearEnough);

/// \param outcome  developable; becomes what is closer
void comeCloser(NewtonProblem& problem, int maxIterations, NewtonOutcome& outcome, const Progress& progress);

/// The same for a part, if it has panels that are sewn together.
void comeCloser(const PatchAssembly& part, const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
				NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
