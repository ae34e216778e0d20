// SPDX-License-Identifier: GPL-3.0-or-later
// frozen_panels.cpp: one panel after the other is frozen.
#include "frozen_panels.h"

namespace developable::detail {

FrozenPanels::FrozenPanels(const PatchAssembly& assembly, const Positions& start,
						   const NewtonStrategy& strategy, const Progress& progress)
	: assembly_(assembly), start_(start), strategy_(strategy), progress_(progress),
	  soundness_(assembly, strategy.tuning()), startDefects_(flatDefects(assembly, start)),
	  frozen_(Patches::Constant(assembly.patchCount(), false)) {}

NewtonOutcome FrozenPanels::finishOthers(NewtonOutcome outcome) {
	for (Patches left = unmet(outcome.positions);
		 left.count() > 1 && outcome.ending != Ending::Stopped && !strategy_.budget().spent();
		 left = unmet(outcome.positions) && !frozen_) {
		freezeWorst(left, outcome.positions);
		PartialAssembly others =
			partialAssembly(assembly_, trianglesWhere(assembly_.triangleCopies, [&](int t) {
								return !frozen_[assembly_.patchOfTriangle[t]];
							}));
		// Seams go where the others want them, if the triangles on their other sides allow it.
		if (!solveFor(others, outcome) && holdSeams(others))
			solveFor(others, outcome);
	}
	return outcome;
}

FrozenPanels::Patches FrozenPanels::unmet(const Positions& positions) const {
	return strategy_.goal().unmetPatches(assembly_, flatDefects(assembly_, positions));
}

void FrozenPanels::freezeWorst(const Patches& candidates, const Positions& positions) {
	const Eigen::ArrayXd curvature = patchCurvatures(assembly_, flatDefects(assembly_, positions));
	int worst = 0;
	candidates.select(curvature, -1).maxCoeff(&worst);
	frozen_[worst] = true;
}

bool FrozenPanels::solveFor(const PartialAssembly& others, NewtonOutcome& outcome) const {
	const NewtonOutcome result =
		strategy_.solve(others.assembly, start_(Eigen::all, others.wholePlace), progress_);
	outcome.iterations += result.iterations;
	if (result.ending == Ending::Stopped) {
		outcome.ending = Ending::Stopped;
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

bool FrozenPanels::holdSeams(PartialAssembly& others) const {
	std::vector<char> shared(assembly_.placeCount(), 0);
	for (int copy = 0; copy < assembly_.copyCount(); ++copy)
		if (frozen_[assembly_.patchOfCopy[copy]])
			shared[assembly_.placeOfCopy[copy]] = 1;
	for (int place = 0; place < others.assembly.placeCount(); ++place)
		if (shared[others.wholePlace[place]])
			others.assembly.placeFixed[place] = 1;
	return holdsPlaces(others.assembly);
}

bool FrozenPanels::acceptable(const Positions& positions, const Positions& before) const {
	return unmet(positions).count() < unmet(before).count() && soundness_.holds(positions) &&
		   better(assembly_, flatDefects(assembly_, positions), startDefects_);
}

} // namespace developable::detail
