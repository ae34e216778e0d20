// SPDX-License-Identifier: GPL-3.0-or-later
// continuation.h: from the original to where next to nothing of the curvature is left, by a falling ε.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// Gauss-Newton steps on φ with τ = 1, first with a large ε, which is lessened as soon as it holds the steps
/// up: x(ε) leaves the original continuously and ends, as ε → 0, where ‖d‖_W is least among the shapes with
/// g = 0.
class Continuation {
public:
	/// \param share  of the first ε, to begin with
	Continuation(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double share = 1);

	/// With every step places become the heavier the farther they have come, such that others move in their
	/// stead.
	/// \param bound  the displacement at which they do, length; 0: none do
	void makeFarPlacesHeavy(double bound) { bound_ = bound; }

	/// \return Settled, when the curvature is all but gone and the distance has settled; Stuck, when it leads
	///         no further; Reached; TooFar; Unsolvable; OutOfSteps; Stopped
	Ending follow();

	/// The ε that it ended with, and the least that it may have.
	double epsilon() const { return epsilon_; }
	double leastEpsilon() const { return leastEpsilon_; }

private:
	/// \return whether the metric can be factorised then
	bool weighFarPlaces();

	NewtonProblem& problem_;
	NewtonRun& run_;
	GaussNewton& steps_;
	double epsilon_, leastEpsilon_;
	double bound_ = 0; // no place becomes heavier
};

} // namespace developable::detail
