// SPDX-License-Identifier: GPL-3.0-or-later
// gauss_newton.h: steps in all three directions, for the continuation and for the restoration.
#pragma once

#include "multiplier_solver.h"
#include "newton_run.h"

namespace developable::detail {

/// With d = x − x0 the displacement and g the scaled defects, a Gauss-Newton step on
///     φ(x) = τ ½‖d‖²_W + 1/(2ε) |g|²
/// is found from its multipliers y:
///     (J W⁻¹ Jᵀ + ε) y = g − τ J d,    s = −τ d − W⁻¹ Jᵀ y.
class GaussNewton {
public:
	/// \param stiffens  whether triangles that a step would spoil are made stiffer
	/// \param farthest  that steps may bring a place from where it was, length
	GaussNewton(NewtonProblem& problem, NewtonRun& run, bool stiffens,
				double farthest = std::numeric_limits<double>::infinity());

	/// From now on triangles that a step would spoil are made stiffer.
	void beginToStiffen() { stiffens_ = true; }

	/// Triangles that were made stiffer are as they were at first. Where there are none, nothing changes.
	void loosen();

	/// About the greatest eigenvalue of J W⁻¹ Jᵀ where the run begins: what ε compares to.
	double greatestResponse() const { return greatestResponse_; }

	/// A step that lowers φ. The multipliers of the step before are the first guess, unless those are
	/// forgotten. \return the step's length as a share of the whole; 0 when none was any good
	double step(double tau, double epsilon);
	void forgetMultipliers() { multipliers_.setZero(); }

	/// See NewtonRun; with the Jacobian, the metric and ε of the last step, if its system was factorised.
	void chords(double epsilon);

	/// φ with τ = 1.
	double merit(const Shape& shape, double epsilon) const { return merit(shape, 1, epsilon); }
	double squaredDistance(const Shape& shape) const;

	/// Whether a step had to heed the limits on borders.
	bool metLimits() const { return metLimits_; }

	/// Whether the last step was cut short by the user, or could not be computed.
	bool stopped() const { return stopped_; }
	bool unsolvable() const { return unsolvable_; }

private:
	double merit(const Shape& shape, double tau, double epsilon) const;
	/// \param foreseen  see MultiplierSolver
	Positions direction(double tau, double epsilon, bool foreseen = false);

	NewtonProblem& problem_;
	NewtonRun& run_;
	bool stiffens_;
	const double farthest_;
	MultiplierSolver solver_;
	Eigen::VectorXd multipliers_; // y
	double greatestResponse_ = 0;
	bool stopped_ = false, unsolvable_ = false, metLimits_ = false;
};

} // namespace developable::detail
