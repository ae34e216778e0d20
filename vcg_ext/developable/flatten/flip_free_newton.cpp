// SPDX-License-Identifier: GPL-3.0-or-later
// flip_free_newton.cpp: the minimisation, its steps and their directions.
#include "flip_free_newton.h"

#include "developable/descent/descent.h"

#include <algorithm>

namespace developable::detail {

FlatMinimum FlipFreeNewton::minimize(int iterations, const Progress& progress) {
	constexpr int review = 20; // steps after which it is seen whether they were worth it
	constexpr double worthWide = 0.05, worthNarrow = 0.01; // share of the energy
	FlatMinimum result;
	// A wide barrier first: it sees flips coming, so that steps can be long.
	setBarrier(1);
	result.converged = energy_ <= isometricEnergy_;
	double energyBefore = energy_;
	for (int steps = 1; !result.converged && result.iterations < iterations; ++steps) {
		if (!mayGoOn(progress, double(result.iterations) / iterations, "Flattening")) {
			result.stopped = true;
			return result;
		}
		const double decrease = step();
		++result.iterations;
		const bool wide = springs_.guardedShare() == 1;
		const bool crawls =
			steps == review && energy_ > (1 - (wide ? worthWide : worthNarrow)) * energyBefore;
		if (energy_ <= isometricEnergy_) {
			result.converged = true;
		} else if (wide && (crawls || decrease <= 1e-4 * energy_)) {
			setBarrier(PlaneSprings::leastGuardedShare);
			steps = review; // seen anew with this barrier
		} else if (!wide) {
			result.converged = decrease <= 1e-10 * energy_;
			if (crawls)
				break; // a panel that folds: more steps would make no difference to anyone
		}
		if (steps == review) {
			energyBefore = energy_;
			steps = 0;
		}
	}
	return result;
}

void FlipFreeNewton::lessenMeanStrain() {
	if (energy_ <= isometricEnergy_)
		return;
	for (int iteration = 0; iteration < 2; ++iteration) {
		springs_.weighForMeanStrain(positions_, shareOfMeanStrain);
		energy_ = springs_.guardedEnergy(positions_);
		step();
	}
}

void FlipFreeNewton::setBarrier(double guardedShare) {
	springs_.setGuardedShare(guardedShare);
	energy_ = springs_.guardedEnergy(positions_);
}

double FlipFreeNewton::step() {
	const PlanePositions gradient = springs_.gradient(positions_);
	const PlanePositions direction = descent(gradient);
	const double slope = gradient.cwiseProduct(direction).sum();
	double length = std::min(1.0, 0.9 * springs_.longestStep(positions_, direction));
	const bool fullStep = length == 1;
	for (int trial = 0; trial < 40; ++trial, length /= 2) {
		const PlanePositions moved = positions_ + length * direction;
		const double energy = springs_.guardedEnergy(moved);
		if (!descendsEnough(energy_, slope, length, energy))
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

PlanePositions FlipFreeNewton::descent(const PlanePositions& gradient) {
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

} // namespace developable::detail
