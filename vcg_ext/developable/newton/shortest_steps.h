// SPDX-License-Identifier: GPL-3.0-or-later
// shortest_steps.h: the nearest developable shape of a surface that is one but for rounding or the like.
#pragma once

#include "newton_run.h"

namespace developable::detail {

/// Steps s = −M⁻¹ Jᵀ (J M⁻¹ Jᵀ + ε)⁻¹ g, the shortest to g = 0 where M are the places' masses (Wang 2008,
/// least norm). They wrinkle what they move far, so they are for places that move by next to nothing beside
/// their edges: then no fold can be seen, and what is nearest is best.
/// \return Reached; Stuck where more than that is needed: then the shape is of no use; Stopped
class ShortestSteps {
public:
	ShortestSteps(NewtonProblem& problem, NewtonRun& run);

	Ending run();

private:
	bool withinReach() const;
	Positions step(double epsilon);

	NewtonProblem& problem_;
	NewtonRun& run_;
	const Eigen::VectorXd inverseMass_;
	const double farthest_;
	SparseSolver solver_;
};

} // namespace developable::detail
