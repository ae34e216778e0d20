// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.h: to g = 0 by small steps along the normals, from a shape that is nearly there.
#pragma once

#include "curvature_goal.h"
#include "multiplier_solver.h"
#include "normal_system.h"
#include "soundness.h"
#include "sparse_solver.h"
#include "vertex_normals.h"

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
	NewtonOutcome run(const Positions& start, double farthest, int maxIterations) {
		NewtonOutcome outcome;
		farthest_ = farthest;
		moveTo(start);
		startCurvature_ = defects_.cwiseAbs().sum();
		outcome.status = iterate(maxIterations);
		outcome.iterations = iterations_;
		outcome.positions = positions_;
		return outcome;
	}

private:
	static constexpr double firstShare = 0.01; ///< of ‖N u‖²_W in the first system's trace
	static constexpr int chordLimit = 6;       ///< steps with one factorisation
	static constexpr int idleLimit = 5;        ///< steps in a row that remove less than 2 % of |g|²

	Status iterate(int maxIterations) {
		for (int idle = 0; !reached_;) {
			if (!mayGoOnNow())
				return Status::Stopped;
			if (iterations_ == maxIterations)
				return Status::LimitReached;
			++iterations_;
			const double before = scaled_.squaredNorm();
			const double length = factorize() ? stepsWithOneFactorization() : 0;
			const double share = scaled_.squaredNorm() / before;
			idle = share > 0.98 ? idle + 1 : 0;
			if (idle == idleLimit)
				return Status::Stalled;
			epsilon_ *= epsilonFactor(share, length);
		}
		return Status::Converged;
	}

	/// Smaller after a full step, the more so the more it removed; larger where the step had to be cut short.
	static double epsilonFactor(double shareLeft, double length) {
		if (shareLeft < 0.5)
			return shareLeft < 0.1 ? 0.1 : 0.3;
		if (length == 0)
			return 16;
		return length == 1 ? 0.5 : length < 0.3 ? 4 : 1;
	}

	void moveTo(const Positions& positions) {
		positions_ = positions;
		defects_ = angleDefects(assembly_, positions);
		scaled_ = jacobian_.scaled(defects_);
		reached_ = !goal_.unmetPatches(assembly_, defects_).any();
	}

	/// Of NᵀJᵀJN + ε NᵀWN at the present positions.
	bool factorize() {
		jacobian_.linearize(positions_);
		normals_ = placeNormals(assembly_, positions_);
		along_ = jacobian_.along(normals_);
		if (epsilon_ == 0) // normals are one long, so W and NᵀWN have the same trace
			epsilon_ = firstShare * along_.squaredNorm() / metric_.matrix().diagonal().sum();
		for (int i = 0; solver_.factorize(system_.fill(along_, normals_, epsilon_)); ++i) {
			firstStep_ = wholeStep();
			if (i == BendingMetric::stiffenings || !stiffen())
				return true;
		}
		return false;
	}

	/// Where the first step would spoil triangles they are made stiffer. \return whether there are any
	bool stiffen() {
		if (metric_.tooStiff())
			return false;
		const std::vector<int> spoilt = soundness_.spoiltTriangles(positions_ + firstStep_);
		metric_.stiffen(spoilt);
		return !spoilt.empty();
	}

	/// From the present positions, with the system as it was factorised last.
	Positions wholeStep() const {
		return normals_ * solver_.solve(Eigen::VectorXd(-(along_.transpose() * scaled_))).asDiagonal();
	}

	/// A first step with line search, then chords: full steps with new right-hand sides, as long as each
	/// removes half of |g|². \return the first step's length, 0 when none was any good
	double stepsWithOneFactorization() {
		const double length = tryStep(firstStep_, 8);
		for (int chord = 1; chord < chordLimit && length > 0 && !reached_ && mayGoOnNow(); ++chord) {
			const double before = scaled_.squaredNorm();
			if (tryStep(wholeStep(), 1) == 0 || scaled_.squaredNorm() > 0.5 * before)
				break;
		}
		return length;
	}

	double tryStep(const Positions& whole, int lengths) {
		const double before = scaled_.squaredNorm();
		double length = 1;
		for (int i = 0; i < lengths; ++i, length /= 2) {
			Positions move = length * whole;
			if (!soundness_.mend(positions_, move))
				continue;
			const Positions candidate = positions_ + move;
			if (farthestDisplacement(assembly_, candidate) > farthest_ ||
				!(jacobian_.scaled(angleDefects(assembly_, candidate)).squaredNorm() <
				  (1 - 1e-4 * length) * before))
				continue;
			moveTo(candidate);
			return length;
		}
		return 0;
	}

	bool mayGoOnNow() const {
		const double left = defects_.cwiseAbs().sum();
		return mayGoOn(progress_, goal_.shareRemoved(startCurvature_, left),
					   describeCurvature(startCurvature_, left, iterations_));
	}

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
