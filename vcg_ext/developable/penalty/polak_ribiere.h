// SPDX-License-Identifier: GPL-3.0-or-later
// polak_ribiere.h: the nonlinear conjugate gradients of Polak and Ribière (1969).
#pragma once

#include "penalty_function.h"

#include <functional>

namespace developable::detail {

/// Lowers the penalty function. The direction turns back to the steepest descent when it would not lead down.
class PolakRibiere {
public:
	/// \param firstMove  the largest move of a place that the first line search tries, length
	explicit PolakRibiere(double firstMove) : largestMove_(firstMove) {}

	/// Takes steps from the positions, beginning with the steepest descent.
	/// \param keepGoing  asked before each step
	/// \return           false when the run was asked to stop
	bool run(const PenaltyFunction& function, Positions& positions, int steps,
			 const std::function<bool()>& keepGoing);

private:
	bool advance(const PenaltyFunction& function, Positions& positions, const Positions& gradient,
				 const Positions& direction);

	double largestMove_;
};

} // namespace developable::detail
