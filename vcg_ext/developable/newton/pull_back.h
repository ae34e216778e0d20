// SPDX-License-Identifier: GPL-3.0-or-later
// pull_back.h: to within a bound on displacements, where only some places went beyond it.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// Takes a run to its shape with places pulled back to a bound. \return whether that is sound; else the run
/// stays where it is
bool goBackWithin(NewtonProblem& problem, NewtonRun& run, double bound);

/// Steps along the normals that keep a bound on displacements. Where they are stuck, places at the bound
/// become heavy, and stay so, and the run begins again: it goes so many rounds at most. Where it may do that,
/// a developable shape is known to be near, and it may take local steps.
/// \param bound  from the original, length
Ending stepsWithin(NewtonProblem& problem, NewtonRun& run, double bound, int rounds);

/// From the developable shape of a run to one near it whose places stay within a bound: those beyond it are
/// pulled back, and steps along the normals remove the curvature that this brings. Where places at the bound
/// hold them up, these become heavy. A smaller share of the whole displacement is tried, too: its peaks are
/// lower.
/// \param bound  from the original, length
/// \return       Reached; Stuck, with the shape as it was; Stopped
Ending pullBackWithin(NewtonProblem& problem, NewtonRun& run, double bound);

/// Whether a part is small enough for ways back to within the preferred move, which are dear.
bool isSmallEnoughToReturn(const NewtonProblem& problem);

/// While it lasts, what is done on ways back to within how far a place had better move may take so many times
/// the rest, on levels without rounds the less the larger they are. Panels that are sewn together pull at
/// each other: on levels with rounds they have all the work that there is.
/// \param begin  of the rest
ExtraWork workWithinPreferred(NewtonProblem& problem, const WorkBudget& begin = WorkBudget());

/// Whether a way from a developable shape back to within how far a place had better move is worth its while:
/// where much of the original's curvature comes back with the places beyond it, it is none of a few places,
/// and nothing developable is that near.
bool mayBePreferred(const NewtonProblem& problem, const Shape& shape);

/// The same as pullBackWithin for how far a place had better move at most, where the mean displacement hardly
/// grows by it. \return  Reached, too, where there is no other way to within that than this, or none at all
Ending pullBackWithinPreferred(NewtonProblem& problem, NewtonRun& run);

} // namespace developable::detail
