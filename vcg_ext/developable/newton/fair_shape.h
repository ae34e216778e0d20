// SPDX-License-Identifier: GPL-3.0-or-later
// fair_shape.h: the original without its small bumps.
#pragma once

#include "curvature_goal.h"
#include "unfairness.h"

namespace developable::detail {

/// The original as an assembly with other original positions, of which the unfairness is nearly the least.
/// Held places stay, and no place moves farther than the goal allows.
PatchAssembly fairShape(const Unfairness& unfairness, const CurvatureGoal& goal, const NewtonTuning& tuning);

} // namespace developable::detail
