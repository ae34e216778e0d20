// SPDX-License-Identifier: GPL-3.0-or-later
// direct_newton.h: the constrained Newton method on one level, with more smoothness where it leads nowhere.
#pragma once

#include "newton_attempt.h"

namespace developable::detail {

/// Up to five attempts from the same start: where the first leads nowhere, triangles that are in the way are
/// made stiffer; patches that end where they are not developable then are tried again with 4, 16 and 64 times
/// the smoothness. \return the best shape that was found; the start when none is better
NewtonOutcome solveDirectly(const PatchAssembly& assembly, const Positions& start, double smoothness,
							const CurvatureGoal& goal, int maxIterations, const Progress& progress);

} // namespace developable::detail
