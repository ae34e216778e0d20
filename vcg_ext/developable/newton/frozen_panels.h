// SPDX-License-Identifier: GPL-3.0-or-later
// frozen_panels.h: panels that can't be made developable are frozen, so that the others get there.
#pragma once

#include "newton_strategy.h"

namespace developable::detail {

/// Goes on where the method is stuck. The panel with most curvature left may have no developable shape near,
/// and it holds up the others, for steps are as long as the worst triangle lets them be. So it is frozen and
/// the others begin anew without it; if that does not do, the next one is frozen too.
class FrozenPanels {
public:
	/// \param start  of the whole run
	FrozenPanels(const PatchAssembly& assembly, const Positions& start, const NewtonStrategy& strategy,
				 const Progress& progress);

	NewtonOutcome finishOthers(NewtonOutcome outcome);

private:
	using Patches = Eigen::Array<bool, Eigen::Dynamic, 1>;

	/// The patches that are not developable.
	Patches unmet(const Positions& positions) const;

	void freezeWorst(const Patches& candidates, const Positions& positions);

	/// With the frozen patches in the shape that they have been given, or else in that which they began
	/// with. \return false when neither will do
	bool solveFor(const PartialAssembly& others, NewtonOutcome& outcome) const;

	/// Says whether there are any to hold.
	bool holdSeams(PartialAssembly& others) const;

	bool acceptable(const Positions& positions, const Positions& before) const;

	const PatchAssembly& assembly_;
	const Positions& start_;
	const NewtonStrategy& strategy_;
	const Progress progress_;
	const Soundness soundness_;
	const Eigen::VectorXd startDefects_;
	Patches frozen_;
};

} // namespace developable::detail
