// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.h: one run of the constrained Newton method, from the original towards g = 0.
#pragma once

#include "curvature_goal.h"
#include "multiplier_solver.h"
#include "soundness.h"

namespace developable::detail {

/// With d = x − x0 the displacement and g the scaled defects, both parts of the run take Gauss-Newton steps
/// on φ(x) = τ ½‖d‖²_W + 1/(2ε) |g|², found from their multipliers y:
///     (J W⁻¹ Jᵀ + ε) y = g − τ J d,    s = −τ d − W⁻¹ Jᵀ y.
/// The *path*, τ = 1, starts with a large ε and lessens it: x(ε) leaves the original continuously and ends,
/// as ε → 0, where ‖d‖_W is least among the shapes with g = 0. When next to nothing is left of the curvature
/// the *landing*, τ = 0, takes the shortest steps to g = 0, which converge quadratically.
class NewtonAttempt {
public:
	/// \param stiffens  whether triangles that a step would spoil are made stiffer
	NewtonAttempt(const PatchAssembly& assembly, const Eigen::VectorXd& smoothness, bool stiffens,
				  const CurvatureGoal& goal, const Progress& progress);

	NewtonOutcome run(const Positions& start, int maxIterations);

	/// The landing alone, from a shape that is nearly there.
	NewtonOutcome landFrom(const Positions& start, int maxIterations);

private:
	static constexpr double residualShare = 0.05; ///< what a step leaves of its linear system
	static constexpr int idleLimit = 5; ///< landing steps in a row that remove less than a hundredth of |g|²

	struct State {
		Positions positions;
		Eigen::VectorXd scaled;     // g
		double curvature = 0;       // C
		double squaredDistance = 0; // ‖d‖²
		bool reached = false;
	};

	void begin(const Positions& start, int maxIterations);

	/// A developable shape that is not near the original any more is none that was looked for.
	NewtonOutcome outcome(Status status) const;

	State stateAt(const Positions& positions) const;

	void moveTo(State state);

	double merit(const State& state, double tau) const;

	/// Ends when the curvature is all but gone and the distance has settled, or when it leads no further:
	/// then the landing takes over.
	Status followPath();

	/// Ends at g = 0, or where steps have stopped to make a difference.
	Status land();

	/// One step. \return its length, 0 when none is any good
	double step(double tau);

	Positions findDirection(double tau);

	/// Where the whole step would spoil triangles they are made stiffer. \return whether there are any
	bool stiffen(const Positions& direction);

	/// \return the length of the step along a direction, or 0
	double search(const Positions& direction, double tau);

	bool mayGoOnNow() const;

	const PatchAssembly& assembly_;
	const CurvatureGoal goal_;
	const bool stiffens_;
	const Progress& progress_;
	BendingMetric metric_;
	DefectJacobian jacobian_;
	MultiplierSolver solver_;
	Soundness soundness_;
	State state_;
	double diagonal_ = 0;
	Positions lastNear_;
	Eigen::VectorXd multipliers_; // y, the next step's first guess
	double startCurvature_ = 0, epsilon_ = 0, leastEpsilon_ = 0;
	int iterations_ = 0, maxIterations_ = 0;
	bool stopped_ = false;
};

} // namespace developable::detail
