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

	NewtonOutcome finishOthers(NewtonOutcome outcome) {
		for (Patches left = unmet(outcome.positions); left.count() > 1 && outcome.status != Status::Stopped;
			 left = unmet(outcome.positions) && !atRest_) {
			int worst = 0;
			const Eigen::ArrayXd curvature =
				patchCurvatures(assembly_, angleDefects(assembly_, outcome.positions));
			left.select(curvature, -1).maxCoeff(&worst);
			atRest_[worst] = true;
			PartialAssembly others =
				partialAssembly(assembly_, trianglesWhere(assembly_.triangleCopies, [&](int t) {
									return !atRest_[assembly_.patchOfTriangle[t]];
								}));
			// Seams go where the others want them, if the triangles on their other sides allow it.
			if (!solveFor(others, outcome) && holdSeams(others))
				solveFor(others, outcome);
		}
		return outcome;
	}

private:
	/// The first run has been half of the work, as far as one can tell.
	static Progress ofOthers(const Progress& progress) {
		if (!progress)
			return {};
		return [progress](double fraction, const std::string& message) {
			return progress(0.5 + fraction / 2, "without panels that need a cut: " + message);
		};
	}

	using Patches = Eigen::Array<bool, Eigen::Dynamic, 1>;

	/// The patches that are not developable.
	Patches unmet(const Positions& positions) const {
		return goal_.unmetPatches(assembly_, angleDefects(assembly_, positions));
	}

	/// With the patches at rest in the shape that they have been given, or else in that which they began
	/// with. \return false when neither will do
	bool solveFor(const PartialAssembly& others, NewtonOutcome& outcome) const {
		const NewtonOutcome result =
			solver_.solve(others.assembly, start_(Eigen::all, others.wholePlace), progress_);
		outcome.iterations += result.iterations;
		if (result.status == Status::Stopped) {
			outcome.status = Status::Stopped;
			return true;
		}
		for (Positions positions : {outcome.positions, start_}) {
			positions(Eigen::all, others.wholePlace) = result.positions;
			if (acceptable(positions, outcome.positions)) {
				outcome.positions = positions;
				return true;
			}
		}
		return false;
	}

	/// Says whether there are any to hold.
	bool holdSeams(PartialAssembly& others) const {
		std::vector<char> shared(assembly_.placeCount(), 0);
		for (int copy = 0; copy < assembly_.copyCount(); ++copy)
			if (atRest_[assembly_.patchOfCopy[copy]])
				shared[assembly_.placeOfCopy[copy]] = 1;
		for (int place = 0; place < others.assembly.placeCount(); ++place)
			if (shared[others.wholePlace[place]])
				others.assembly.placeFixed[place] = 1;
		return holdsPlaces(others.assembly);
	}

	bool acceptable(const Positions& positions, const Positions& before) const {
		return unmet(positions).count() < unmet(before).count() && soundness_.holds(positions) &&
			   better(assembly_, angleDefects(assembly_, positions), startDefects_);
	}

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
