// SPDX-License-Identifier: GPL-3.0-or-later
// closer_shapes.h: from a developable shape to ones whose farthest place is nearer.
#pragma once

#include "attempts.h"
#include "constrained_newton.h"

namespace developable::detail {

/// Lowers the bound on displacements below how far the farthest place is, by NewtonTuning::closerStep, and
/// restores within it; time and again, as long as that leads within the bound and places are hardly farther
/// on average, down to NewtonTuning::closerFrom of how far a place had better move.
/// \param outcome  developable, no farther away than NewtonTuning::closerReach of that; becomes what is
/// closer
void comeCloser(NewtonProblem& problem, int maxIterations, NewtonOutcome& outcome, const Progress& progress);

/// The same for a part, if it has panels that are sewn together.
void comeCloser(const PatchAssembly& part, const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
				NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
