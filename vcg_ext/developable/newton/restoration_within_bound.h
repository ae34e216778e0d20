// SPDX-License-Identifier: GPL-3.0-or-later
// restoration_within_bound.h: to g = 0 without going beyond a bound on displacements.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// A restoration for which a place is the heavier the nearer it has come to a bound on displacements: others
/// move in its stead. What ends beyond the bound all the same is pulled back to a little less than it and
/// restored again, as long as that leads nearer.
/// \param bound  on displacements, length
/// \return       as a restoration; Reached with the nearest of the developable shapes, which may still be
///               beyond the bound
Ending restoreWithin(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound);

} // namespace developable::detail
