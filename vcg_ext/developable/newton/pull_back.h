// SPDX-License-Identifier: GPL-3.0-or-later
// pull_back.h: to within a bound on displacements, where only some places went beyond it.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// From the developable shape of a run to one near it whose places stay within a bound: those beyond it are
/// pulled back, and steps along the normals remove the curvature that this brings. Where places at the bound
/// hold them up, these become heavy. A smaller share of the whole displacement is tried, too: its peaks are
/// lower.
/// \param bound  from the original, length
/// \return       Reached; Stuck, with the shape as it was; Stopped
Ending pullBackWithin(NewtonProblem& problem, NewtonRun& run, double bound);

/// The same for how far a place had better move at most, where the mean displacement hardly grows by it.
Ending pullBackWithinPreferred(NewtonProblem& problem, NewtonRun& run);

/// Makes the places heavy that are at a bound, which push others against it that could go without.
/// \return by how much, per place; empty where there are none
Eigen::VectorXd weighPlacesAtBound(NewtonProblem& problem, const Shape& shape, double bound);

} // namespace developable::detail
