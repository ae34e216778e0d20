// SPDX-License-Identifier: GPL-3.0-or-later
// least_curvature.h: where there is no way to g = 0, as little curvature as can be, at few places.
#pragma once

#include "attempts.h"
#include "constrained_newton.h"
#include "normal_step.h"

namespace developable::detail {

/// Steps along the normals that lower Σ √(g² + δ²) by least squares with weights 1/√(g² + δ²), as Weiszfeld
/// (1937) has them, while δ falls: towards the least C. The least squares of g spread what can't go over all
/// places, and have up to twice as much of it.
class LeastCurvature {
public:
	LeastCurvature(NewtonProblem& problem, NewtonRun& run);

	/// \return Reached; Stuck, where steps make next to no difference any more; OutOfSteps; Stopped
	Ending run();

private:
	/// \return its length as a share of the whole; 0 when none was any good
	double step();
	double epsilonFactor(double shareLeft, double length) const;
	/// Of each row, rad.
	Eigen::ArrayXd defects(const Shape& shape) const;
	/// Σ √(g² + δ²), rad.
	double merit(const Shape& shape) const {
		return (defects(shape).square() + delta_ * delta_).sqrt().sum();
	}

	NewtonProblem& problem_;
	NewtonRun& run_;
	NormalStep step_;
	double delta_; // rad
	double epsilon_ = 0;
};

/// Goes on from a shape that is stuck to one with less curvature, if there is any; patches that are
/// developable keep their places.
/// \param start    of the whole run
/// \param outcome  becomes what is less curved
void lowerCurvature(const PatchAssembly& part, const Positions& start,
					const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
					NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
