// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.h: one attempt of the constrained Newton method on one level.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// What an attempt may do.
struct AttemptSetting {
	double smoothness = 0;      ///< α
	bool limitsBorders = false; ///< borders may not kink
	int maxIterations = 0;
	bool stiffens = false; ///< triangles that are in the way are made stiffer from the start
	/// Of the work, for what comes after this attempt: not kept any more where nothing does.
	WorkReserve* forNext = nullptr;

	void nothingFollows() const {
		if (forNext != nullptr)
			forNext->release();
	}
};

/// What came of it.
struct AttemptResult {
	Ending ending = Ending::Stuck;
	int iterations = 0;
	Positions positions; ///< the last within the bound on displacements
	/// How far the nearest developable shape found moves a place, where that is too far, length; else 0.
	double nearestDevelopable = 0;
	bool metLimits = false;      ///< borders came to their limits
	bool cameNear = false;       ///< little of the curvature was left, however far away
	bool bordersLimited = false; ///< to the end
};

/// From the start to a developable shape within the bound on displacements: a continuation and a restoration.
/// Panels that are sewn together try to stay within how far a place had better move all the way first.
AttemptResult attempt(NewtonProblem& problem, const Positions& start, const AttemptSetting& setting,
					  const Progress& progress);

/// A restoration alone, from a shape that is nearly there.
/// \param smoothness  α
AttemptResult restoreFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress);

} // namespace developable::detail
