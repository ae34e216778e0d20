// SPDX-License-Identifier: GPL-3.0-or-later
// polak_ribiere.cpp: the steps of the nonlinear conjugate gradients.
#include "polak_ribiere.h"

#include "developable/descent/descent.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

bool PolakRibiere::run(const PenaltyFunction& function, Positions& positions, int steps,
					   const std::function<bool()>& keepGoing) {
	Positions gradient = function.gradient(positions), direction = -gradient;
	for (int step = 0; step < steps; ++step) {
		if (!keepGoing())
			return false;
		if (!(gradient.cwiseProduct(direction).sum() < 0))
			direction = -gradient;
		if (!advance(function, positions, gradient, direction))
			return true;
		if (step + 1 == steps)
			return true;
		const Positions next = function.gradient(positions);
		const double beta = next.cwiseProduct(next - gradient).sum() / gradient.squaredNorm();
		gradient = next;
		direction = std::max(beta, 0.0) * direction - gradient;
	}
	return true;
}

/// \return false where no step leads down
bool PolakRibiere::advance(const PenaltyFunction& function, Positions& positions, const Positions& gradient,
						   const Positions& direction) {
	const double slope = gradient.cwiseProduct(direction).sum();
	const double reach = std::sqrt(direction.colwise().squaredNorm().maxCoeff());
	if (!(slope < 0) || !(reach > 0))
		return false;
	const auto along = [&](double length) { return function.value(positions + length * direction); };
	const double length = lineSearch(along, function.value(positions), slope, largestMove_ / reach);
	if (length == 0)
		return false;
	positions += length * direction;
	largestMove_ = length * reach;
	return true;
}

} // namespace developable::detail
