// SPDX-License-Identifier: GPL-3.0-or-later
// restoration.h: the shortest steps to g = 0, from a shape that is nearly there.
#pragma once

#include "gauss_newton.h"

namespace developable::detail {

/// Gauss-Newton steps on |g|² alone, τ = 0, with an ε that falls with every full step, so that they converge
/// quadratically, and rises with those that had to be cut short (Levenberg and Marquardt). Where stiff
/// triangles or heavy places alone hold up the end triangles are loosened, and ε falls further.
class Restoration {
public:
	/// \param epsilon  the first
	Restoration(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double epsilon);

	/// \return Reached; Stuck, where steps have stopped to make a difference; Unsolvable; OutOfSteps; Stopped
	Ending restore();

private:
	bool crawls(const std::vector<double>& squares) const;
	bool heldUp(double length, double left) const;
	void yieldMore();

	NewtonProblem& problem_;
	NewtonRun& run_;
	GaussNewton& steps_;
	double epsilon_, least_; // ε, and below what it does not fall
};

/// Of ε after a step.
/// \param length  as a share of the whole step; 0 when none was any good
double restorationFactor(double length, const NewtonTuning& tuning);

} // namespace developable::detail
