// SPDX-License-Identifier: GPL-3.0-or-later
// closer_runs.h: sewn panels within less than the preferred displacement, where that is easy.
#pragma once

#include "newton_strategy.h"

namespace developable::detail {

/// Bounds on displacements that are tried are the preferred one and, each NewtonTuning::closerStep of the one
/// before, all below it: they are the same whatever else a run is asked for.
/// \return the largest that is within NewtonTuning::preferredLength, length
double boundWithin(const PatchAssembly& part, const NewtonTuning& tuning);

/// Whether a part has panels that are sewn together, and is small enough to be solved more than once.
bool mayComeCloser(const PatchAssembly& part, const NewtonTuning& tuning);

/// Where few places of a developable shape moved nearly as far as the farthest, all may move less: tries the
/// least bound that few are beyond; from there ever lower ones while they are kept, or else higher ones.
/// \param strategy  which led from the start to the outcome
/// \param outcome   becomes what is closer
void comeCloser(const PatchAssembly& part, const Positions& start, NewtonStrategy strategy,
				NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
