// SPDX-License-Identifier: GPL-3.0-or-later
// attempts.h: the constrained Newton method on one level, with more smoothness where it leads nowhere.
#pragma once

#include "newton_attempt.h"

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
	Positions unlimited = {};    ///< what the first attempt without limits on borders came to
};

/// Up to six attempts from the same start: one that keeps borders from kinking; one that does not, unless no
/// border came to its limit; then triangles that are in the way are made stiffer, too; and patches that end
/// where they are not developable are tried again with 4, 16 and 64 times the smoothness. Where an attempt
/// takes long and another thread is at hand, the next begins there already, if it does not depend on how this
/// one ends: what comes of it is the same.
/// \param smoothness  α
/// \return            the developable shape, or the least curved of all attempts; the start when none is
/// better
NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress);

} // namespace developable::detail
