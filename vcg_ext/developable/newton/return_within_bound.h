// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.h: from a developable shape that is too far away to one within the bound on
// displacements.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// Goes on from a developable shape with a place farther away than it may be. Places beyond the bound, or
/// nearly, are made heavier in the metric, the more so the farther they are, and a continuation leads to
/// where the distance is least now; so again and again. That is Lawson's way (1961) from least squares to the
/// least of the largest.
class ReturnWithinBound {
public:
	/// \param bound  on displacements, length
	ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound);

	/// \return Reached, with a shape within the bound; Stuck, with the run at any shape; OutOfSteps; Stopped;
	///         Unsolvable
	Ending run();

	/// The least largest displacement of the developable shapes on the way, the first included; length.
	double nearest() const { return nearest_; }

private:
	void makeFarPlacesHeavier();
	void makeLighter();

	/// A continuation and a restoration, from the present shape.
	Ending round();

	NewtonProblem& problem_;
	NewtonRun& run_;
	GaussNewton& steps_;
	const double bound_;
	Eigen::VectorXd masses_; ///< of the places, as they have become
	double nearest_;
};

} // namespace developable::detail
