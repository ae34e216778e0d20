// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.h: from a developable shape that is too far away to one within the bound on
// displacements.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// Walks on from a developable shape with a place farther away than it may be, to ones whose farthest place
/// is nearer: Lawson's algorithm (1961) for the least of the largest, among developable shapes. In each round
/// every place has become heavier in the metric by its share of the largest displacement; two steps lead
/// towards the original as far as the curvature that they bring is not too dear, places still beyond the
/// bound are pulled back to it, and a restoration takes the shortest steps to where all is developable again.
/// Where that is no nearer, curvature is dearer in the next round.
class ReturnWithinBound {
public:
	/// \param bound  on displacements, length
	ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound);

	/// Ends with the run at the nearest of the developable shapes on the way.
	/// \return Reached, where that is within the bound; Stuck; OutOfSteps; Stopped; Unsolvable
	Ending run();

	/// The nearest of the developable shapes on the way, the first included.
	const Shape& found() const { return found_; }

private:
	Ending goNearer();
	double dearCurvature() const;
	/// From the nearest shape so far.
	/// \param epsilon  ε: the less, the dearer is curvature
	Ending round(double epsilon);
	/// \return Settled, with the run nearer to the original
	Ending approachOriginal(double epsilon);
	void makeFarPlacesHeavier();

	NewtonProblem& problem_;
	NewtonRun& run_;
	GaussNewton& steps_;
	const double bound_;
	Eigen::VectorXd masses_; ///< of the places, as they have become
	Eigen::ArrayXd weights_; ///< what they have become heavier by, 1 at most
	Shape found_;
};

/// Rounds towards how far a place had better move. \return Reached, with the shape as it was where that leads
/// nowhere; Stopped
Ending returnToPreferred(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps);

/// Pulls such a shape back; where that leads nowhere, goes rounds if it may.
/// \param begin  of what the work on this way is measured by, see ExtraWork
/// \return       the same
Ending withinPreferred(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps,
					   const WorkBudget& begin = WorkBudget());

} // namespace developable::detail
