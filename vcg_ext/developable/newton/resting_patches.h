// SPDX-License-Identifier: GPL-3.0-or-later
// resting_patches.h: patches that can't be made developable are laid to rest, so that the others get there.
#pragma once

#include "multilevel_newton.h"

namespace developable::detail {

/// Goes on where the method has stalled. The patch with most curvature left may have no developable shape
/// near, and it holds up the others, for steps are as long as the worst triangle lets them be. So it is laid
/// to rest and the others begin anew without it; if that does not do, the next one is laid to rest too.
class RestingPatches {
public:
	/// \param start  of the whole run
	RestingPatches(const PatchAssembly& assembly, const Positions& start, const MultilevelNewton& solver,
				   const CurvatureGoal& goal, const Progress& progress)
		: assembly_(assembly), start_(start), solver_(solver), goal_(goal), progress_(ofOthers(progress)),
		  soundness_(assembly), startDefects_(angleDefects(assembly, start)),
		  atRest_(Patches::Constant(assembly.patchCount(), false)) {}

	NewtonOutcome finishOthers(NewtonOutcome outcome);

private:
	/// The first run has been half of the work, as far as one can tell.
	static Progress ofOthers(const Progress& progress);

	using Patches = Eigen::Array<bool, Eigen::Dynamic, 1>;

	/// The patches that are not developable.
	Patches unmet(const Positions& positions) const;

	/// With the patches at rest in the shape that they have been given, or else in that which they began
	/// with. \return false when neither will do
	bool solveFor(const PartialAssembly& others, NewtonOutcome& outcome) const;

	/// Says whether there are any to hold.
	bool holdSeams(PartialAssembly& others) const;

	bool acceptable(const Positions& positions, const Positions& before) const;

	const PatchAssembly& assembly_;
	const Positions& start_;
	const MultilevelNewton& solver_;
	const CurvatureGoal& goal_;
	const Progress progress_;
	const Soundness soundness_;
	const Eigen::VectorXd startDefects_;
	Patches atRest_;
};

} // namespace developable::detail
