// SPDX-License-Identifier: GPL-3.0-or-later
// flip_free_newton.h: Newton's method on the springs of a flat panel, in steps that flip no triangle.
#pragma once

#include "../progress.h"
#include "plane_springs.h"

#include <cmath>

namespace developable::detail {

/// Solves H d = r for Hessians that change a little from one to the next: by conjugate gradients, with the
/// Cholesky factor of an earlier one as preconditioner, which is renewed when it no longer serves.
class HessianSolver {
public:
	/// \return  false when the matrix turned out not to be positive definite; the solution always goes down
	bool solve(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide, Eigen::VectorXd& solution) {
		if (factorized_ && conjugateGradients(matrix, rightHandSide, solution))
			return true;
		if (indefinite_)
			return false;
		factorized_ = factor_.factorize(matrix);
		if (factorized_)
			solution = factor_.solve(rightHandSide);
		factorized_ = factorized_ && solution.dot(rightHandSide) > 0;
		return factorized_;
	}

private:
	bool conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
							Eigen::VectorXd& solution) {
		constexpr int mostSteps = 12; // more cost as much as a new factor
		constexpr double tolerance = 1e-3;
		solution = Eigen::VectorXd::Zero(rightHandSide.size());
		Eigen::VectorXd residual = rightHandSide, preconditioned = factor_.solve(residual);
		Eigen::VectorXd direction = preconditioned;
		double product = residual.dot(preconditioned);
		const double enough = tolerance * tolerance * product;
		indefinite_ = false;
		for (int step = 0; step < mostSteps; ++step) {
			const Eigen::VectorXd image = matrix.selfadjointView<Eigen::Lower>() * direction;
			const double curvature = direction.dot(image);
			if (!(curvature > 0)) {
				indefinite_ = true;
				return false;
			}
			solution += product / curvature * direction;
			residual -= product / curvature * image;
			preconditioned = factor_.solve(residual);
			const double last = std::exchange(product, residual.dot(preconditioned));
			if (product <= enough)
				return true;
			direction = preconditioned + product / last * direction;
		}
		return false;
	}

	SparseCholesky factor_;
	bool factorized_ = false, indefinite_ = false;
};

/// How a minimisation ended.
struct FlatMinimum {
	bool converged = false;
	bool stopped = false; ///< by the user
	int iterations = 0;
};

/// Minimises the energy of springs from a layout without flips to one without flips.
class FlipFreeNewton {
public:
	FlipFreeNewton(PlaneSprings& springs, PlanePositions& positions)
		: springs_(springs), positions_(positions), hessian_(springs.hessianPattern()),
		  isometricEnergy_(1e-23 * springs.scale()) {}

	/// \param iterations  at most
	FlatMinimum minimize(int iterations, const Progress& progress) {
		FlatMinimum result;
		// A wide barrier first: it sees flips coming, so that steps can be long.
		setBarrier(1);
		result.converged = energy_ <= isometricEnergy_;
		while (!result.converged && result.iterations < iterations) {
			if (!mayGoOn(progress, double(result.iterations) / iterations, "Flattening")) {
				result.stopped = true;
				return result;
			}
			const double decrease = step();
			++result.iterations;
			if (energy_ <= isometricEnergy_)
				result.converged = true;
			else if (springs_.guardedShare() < 1)
				result.converged = decrease <= 1e-10 * energy_;
			else if (decrease <= 1e-4 * energy_)
				setBarrier(PlaneSprings::leastGuardedShare);
		}
		return result;
	}

	/// From the minimum goes on to a layout near it whose mean edge strain is some per cent less, for an
	/// energy that is some tenths of a per cent more. The least sum of squares spreads strain over many
	/// edges.
	void lessenMeanStrain() {
		if (energy_ <= isometricEnergy_)
			return;
		for (int iteration = 0; iteration < 2; ++iteration) {
			springs_.weighForMeanStrain(positions_, shareOfMeanStrain);
			energy_ = springs_.guardedEnergy(positions_);
			step();
		}
	}

private:
	static constexpr double shareOfMeanStrain = 0.15;

	void setBarrier(double guardedShare) {
		springs_.setGuardedShare(guardedShare);
		energy_ = springs_.guardedEnergy(positions_);
	}

	/// \return  by how much the energy went down, as far as the quadratic model could tell
	double step() {
		const PlanePositions gradient = springs_.gradient(positions_);
		const PlanePositions direction = descent(gradient);
		const double slope = gradient.cwiseProduct(direction).sum();
		double length = std::min(1.0, 0.9 * springs_.longestStep(positions_, direction));
		const bool fullStep = length == 1;
		for (int trial = 0; trial < 40; ++trial, length /= 2) {
			const PlanePositions moved = positions_ + length * direction;
			const double energy = springs_.guardedEnergy(moved);
			if (energy > energy_ + 1e-4 * length * slope)
				continue;
			positions_ = moved;
			energy_ = energy;
			exact_ = fullStep && trial == 0 && -slope < 0.1 * energy_;
			return -slope;
		}
		exact_ = false;
		// Nothing lower along a downward direction: this is the minimum to rounding.
		return 0;
	}

	/// The Newton direction; near the minimum with the exact second derivatives where these are definite.
	PlanePositions descent(const PlanePositions& gradient) {
		const Eigen::VectorXd downward = -gradient.reshaped();
		Eigen::VectorXd solution;
		for (const bool exact : {true, false}) {
			if (exact && !exact_)
				continue;
			// Only rigid motions have no stiffness; this much keeps them where they are.
			hessian_.setDiagonal(1e-9);
			springs_.addHessian(positions_, !exact, hessian_);
			if (solver_.solve(hessian_.matrix(), downward, solution))
				return solution.reshaped(2, gradient.cols());
		}
		return downward.reshaped(2, gradient.cols());
	}

	PlaneSprings& springs_;
	PlanePositions& positions_;
	PlaneHessian hessian_;
	HessianSolver solver_;
	double isometricEnergy_; // below which only rounding is left
	double energy_ = 0;
	bool exact_ = false;
};

} // namespace developable::detail
