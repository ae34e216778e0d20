// SPDX-License-Identifier: GPL-3.0-or-later
// attempts.h: the constrained Newton method on one level: carefully first, then with more freedom.
#pragma once

#include "newton_attempt.h"

namespace developable::detail {

/// How the method ended on one level, or on a part of it.
struct NewtonOutcome {
	Ending ending = Ending::Stuck;
	int iterations = 0;
	Positions positions;
	/// How far the nearest developable shape found moves a place, where that is too far, length; else 0.
	double nearestDevelopable = 0;
	bool bordersLimited = false; ///< found while borders might not kink
	Positions free = {};         ///< what the free attempt came to, where there was one
	double work = 0;             ///< of all runs on a part, in units of WorkBudget; set where these are done

	/// Counts what another run on the same part took, for both. \param workOfOther  in units of WorkBudget
	/// \return whether it ended by itself; else this one was stopped, too
	bool goesOnWith(NewtonOutcome& other, double workOfOther) {
		other.iterations = iterations += other.iterations;
		other.work = work += workOfOther;
		if (other.ending == Ending::Stopped)
			ending = Ending::Stopped;
		return ending != Ending::Stopped;
	}
};

/// Up to two attempts from the same start: a careful one, which keeps borders from kinking, and a free one,
/// which does not; where the careful one came nowhere near, the free one makes triangles stiffer that are in
/// the way. Where the careful one takes long and another thread is at hand, the free one begins there
/// already: what comes of it is the same.
/// \param smoothness  α
/// \return            the developable shape, or the less curved of both; the start when none is better
NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress);

} // namespace developable::detail
