// SPDX-License-Identifier: GPL-3.0-or-later
// other_levels.h: sewn panels from smaller coarse levels, where the usual one leads too far.
#pragma once

#include "newton_strategy.h"

namespace developable::detail {

/// Whether it is developable, and no place is farther than it had better move.
bool isWithinPreferred(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonTuning& tuning);

/// Whether a part has panels that are sewn together, free to move, and is small enough to be solved more than
/// once, but not too small for a coarser level.
bool mayTryOtherLevels(const PatchAssembly& part, const NewtonTuning& tuning);

/// Panels that are sewn together pull at each other, and where a run ends hangs on the triangles of its
/// coarsest level and on the detail that finer ones add: what one leads astray a smaller one, or one near a
/// fair shape without that detail, may lead to a developable shape within how far a place had better move.
/// Nothing is done where that is reached already. \param usual    which led from the start to the outcome
/// \param outcome  becomes what is nearer
void tryOtherLevels(const PatchAssembly& part, const Positions& start, const NewtonStrategy& usual,
					NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
