// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.h: to g = 0 by small steps along the normals, from a shape that is nearly there.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// Steps s = N u along the places' normals N with the least |g + J N u|² + ε ‖N u‖²_W: one unknown a place
/// and one factorisation a step, whose pattern never changes. Moves along the surface hardly change
/// curvature, so little is lost where only what is left of it has to go; what has to move far is moved on a
/// coarser level. ε falls with every step that does what it should and rises with those that don't (Levenberg
/// and Marquardt).
class NormalSteps {
public:
	/// \param farthest  how far from the original a place may go, length
	NormalSteps(NewtonProblem& problem, NewtonRun& run, double farthest);

	/// \return Reached; Stuck, where steps have stopped to make a difference; OutOfSteps; Stopped
	Ending run();

private:
	/// Of NᵀJᵀJN + ε NᵀWN at the present positions. \return whether it succeeded
	bool factorize();

	/// From the present positions, with the system as it was factorised last.
	Positions wholeStep() const;

	/// A first step with line search, then chords: full steps with new right-hand sides, as long as each
	/// removes enough. \return the first step's length, 0 when none was any good
	double stepsWithOneFactorization();
	double tryStep(const Positions& whole, int halvings);

	double epsilonFactor(double shareLeft, double length) const;
	double squaredDefects() const { return run_.shape().scaledDefects.squaredNorm(); }

	NewtonProblem& problem_;
	NewtonRun& run_;
	const double farthest_;
	SparseMatrix along_; // J N
	Positions normals_, firstStep_;
	double epsilon_ = 0;
};

} // namespace developable::detail
