// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.h: from a developable shape that is too far away to one within the bound on
// displacements.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// Walks on from a developable shape with a place farther away than it may be. In each round places beyond a
/// nearer bound are pulled back to it and made heavy in the metric, the more so the farther they are, and a
/// restoration takes the shortest steps to where all is developable again: a little farther away than that
/// bound, but nearer than before. A continuation from so far away would first go back to the original, where
/// heavy places leave no way.
class ReturnWithinBound {
public:
	/// \param bound  on displacements, length
	ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound);

	/// \return Reached, with a shape within the bound; Stuck, with the run at any shape; OutOfSteps; Stopped;
	///         Unsolvable
	Ending run();

	/// The nearest of the developable shapes on the way, the first included.
	const Shape& found() const { return found_; }

	/// Takes the run to that shape with its places pulled back to a bound. \return whether that is sound;
	/// else the run stays where it is
	bool pullBackTo(double bound);

private:
	/// From the nearest shape so far.
	/// \param aim  the nearer bound, length
	Ending round(double aim);
	void makeFarPlacesHeavy(double aim);

	NewtonProblem& problem_;
	NewtonRun& run_;
	GaussNewton& steps_;
	const double bound_;
	Eigen::VectorXd masses_; ///< of the places, as they have become
	Shape found_;
};

} // namespace developable::detail
