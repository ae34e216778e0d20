// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.h: the constrained Newton method on one level, with more smoothness where it leads nowhere.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// How the method ended on one level, or on a part of it.
struct NewtonOutcome {
	Ending ending = Ending::Stuck;
	int iterations = 0;
	Positions positions;
	double smoothness = 0; ///< the largest α that a patch was given
	/// How far the nearest developable shape found moves a place, where that is too far, length; else 0.
	double nearestDevelopable = 0;
	bool bordersLimited = false; ///< found while borders might not kink
};

/// Up to five attempts from the same start, each a continuation and a restoration: where the first leads
/// nowhere, triangles that are in the way are made stiffer; patches that end where they are not developable
/// then are tried again with 4, 16 and 64 times the smoothness.
/// \return the best shape that was found; the start when none is better
NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress);

/// A restoration alone, from a shape that is nearly there.
NewtonOutcome restoreFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress);

} // namespace developable::detail
