// SPDX-License-Identifier: GPL-3.0-or-later
// fine_level.h: from the shape that a coarser level came to, to a developable one on the fine level.
#pragma once

#include "attempts.h"

namespace developable::detail {

/// What a coarser level tells of a fine one.
struct CoarseShape {
	bool developable = false;
	double farthest = 0;    ///< that it moves a place of its own, length
	Positions displacement; ///< of the fine places, from their originals
	/// What displaces the original to a surface without waves that the coarser level does not have; empty on
	/// levels that are too large for that to be tried.
	Positions smoothing;
};

/// Steps along the normals from there. Where the coarse shape is developable and no place of it moves much
/// farther than it had better, first such as keep that bound, from a surface that has given up its short
/// waves: their curvature takes room to move that places at the bound do not have.
NewtonOutcome solveFine(NewtonProblem& problem, const CoarseShape& coarse, int maxIterations,
						const Progress& progress);

} // namespace developable::detail
