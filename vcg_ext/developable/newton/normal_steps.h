// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.h: to g = 0 by small steps along the normals, from a shape that is nearly there.
#pragma once

#include "newton_run.h"
#include "normal_step.h"

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

	/// On a part that is large enough for these to pay, see LocalSteps: for where a developable shape is
	/// near. Steps that are stuck for all that begin again without.
	void allowLocalSteps();

	/// Where that is not enough they count as stuck.
	void takeAtMost(int steps) { most_ = steps; }

	/// \return Reached; Stuck, where steps have stopped to make a difference; OutOfSteps; Stopped
	Ending run();

private:
	/// With local steps or without, as they may be now.
	Ending go();

	/// The first step, whole, with local steps where it leaves too much. \return 1, or 0 where that is no use
	double stepWithLocalSteps();
	/// A first step with line search, then chords. \return the first step's length, 0 when none was any good
	double stepsWithOneFactorization();

	double epsilonFactor(double shareLeft, double length) const;
	double squaredDefects() const { return run_.shape().squaredDefects(); }

	NewtonProblem& problem_;
	NewtonRun& run_;
	const double farthest_;
	NormalStep step_;
	double epsilon_ = 0;
	int most_ = std::numeric_limits<int>::max(), taken_ = 0;
	bool mayGoLocally_ = false, wentLocally_ = false;
};

} // namespace developable::detail
