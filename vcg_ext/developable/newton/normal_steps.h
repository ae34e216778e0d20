// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.h: to g = 0 by small steps along the normals, from a shape that is nearly there.
#pragma once

#include "curvature_goal.h"
#include "developable/geometry/geometry.h"
#include "developable/linear/linear.h"
#include "multiplier_solver.h"
#include "normal_system.h"
#include "soundness.h"

namespace developable::detail {

/// Steps s = N u along the places' normals N with the least |g + J N u|² + ε ‖N u‖²_W: one unknown a place
/// and one factorisation a step, whose pattern never changes. Moves along the surface hardly change
/// curvature, so little is lost where only what is left of it has to go; what has to move far is moved on a
/// coarser level. ε falls with every step that does what it should and rises with those that don't (Levenberg
/// and Marquardt).
class NormalSteps {
public:
	/// \param memoryLimit  see SparseSolver
	NormalSteps(const PatchAssembly& assembly, Soundness soundness, double smoothness,
				const CurvatureGoal& goal, double memoryLimit, const Progress& progress)
		: assembly_(assembly), goal_(goal), progress_(progress),
		  metric_(assembly, Eigen::VectorXd::Constant(assembly.patchCount(), smoothness)),
		  jacobian_(assembly, metric_.placeMass()), soundness_(std::move(soundness)),
		  system_(metric_.matrix()), solver_(memoryLimit) {}

	/// \param farthest  how far from the original a place may go, length
	NewtonOutcome run(const Positions& start, double farthest, int maxIterations);

private:
	static constexpr double firstShare = 0.01; ///< of ‖N u‖²_W in the first system's trace
	static constexpr int chordLimit = 6;       ///< steps with one factorisation
	static constexpr int idleLimit = 5;        ///< steps in a row that remove less than 2 % of |g|²

	Status iterate(int maxIterations);

	/// Smaller after a full step, the more so the more it removed; larger where the step had to be cut short.
	static double epsilonFactor(double shareLeft, double length);

	void moveTo(const Positions& positions);

	/// Of NᵀJᵀJN + ε NᵀWN at the present positions.
	bool factorize();

	/// Where the first step would spoil triangles they are made stiffer. \return whether there are any
	bool stiffen();

	/// From the present positions, with the system as it was factorised last.
	Positions wholeStep() const;

	/// A first step with line search, then chords: full steps with new right-hand sides, as long as each
	/// removes half of |g|². \return the first step's length, 0 when none was any good
	double stepsWithOneFactorization();

	double tryStep(const Positions& whole, int lengths);

	bool mayGoOnNow() const;

	const PatchAssembly& assembly_;
	const CurvatureGoal goal_;
	const Progress& progress_;
	BendingMetric metric_;
	DefectJacobian jacobian_;
	Soundness soundness_;
	NormalSystem system_;
	SparseMatrix along_; // J N
	SparseSolver solver_;
	Positions positions_, normals_, firstStep_;
	Eigen::VectorXd defects_, scaled_; // g, and as the Jacobian scales it
	double farthest_ = 0, startCurvature_ = 0, epsilon_ = 0;
	int iterations_ = 0;
	bool reached_ = false;
};

} // namespace developable::detail
