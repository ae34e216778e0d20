// SPDX-License-Identifier: GPL-3.0-or-later
// newton_part.h: one part of an assembly, by itself, from its start to a verdict.
#pragma once

#include "constrained_newton.h"
#include "newton_strategy.h"

namespace developable::detail {

/// How a part ended.
struct PartOutcome {
	Status status = Status::NothingToDo;
	Ending ending = Ending::Reached;
	int iterations = 0;
	Positions positions;
	double nearestDevelopable = 0; ///< see OptimizationReport
	double work = 0;               ///< in units of WorkBudget
};

/// All patches of a part together; then, where that is stuck, those that need no cut without the others.
/// \param part   the patches of an assembly that share places, see partsOf
/// \param start  3 x places; where it is farther from the original than places may go, the original serves
PartOutcome solvePart(const PatchAssembly& part, const Positions& start,
					  const ConstrainedNewtonOptions& options, const Progress& progress);

} // namespace developable::detail
