// SPDX-License-Identifier: GPL-3.0-or-later
// resting_patches.cpp: one patch after the other is laid to rest.
#include "resting_patches.h"

namespace developable::detail {

NewtonOutcome RestingPatches::finishOthers(NewtonOutcome outcome) {
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

Progress RestingPatches::ofOthers(const Progress& progress) {
	if (!progress)
		return {};
	return [progress](double fraction, const std::string& message) {
		return progress(0.5 + fraction / 2, "without panels that need a cut: " + message);
	};
}

RestingPatches::Patches RestingPatches::unmet(const Positions& positions) const {
	return goal_.unmetPatches(assembly_, angleDefects(assembly_, positions));
}

bool RestingPatches::solveFor(const PartialAssembly& others, NewtonOutcome& outcome) const {
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

bool RestingPatches::holdSeams(PartialAssembly& others) const {
	std::vector<char> shared(assembly_.placeCount(), 0);
	for (int copy = 0; copy < assembly_.copyCount(); ++copy)
		if (atRest_[assembly_.patchOfCopy[copy]])
			shared[assembly_.placeOfCopy[copy]] = 1;
	for (int place = 0; place < others.assembly.placeCount(); ++place)
		if (shared[others.wholePlace[place]])
			others.assembly.placeFixed[place] = 1;
	return holdsPlaces(others.assembly);
}

bool RestingPatches::acceptable(const Positions& positions, const Positions& before) const {
	return unmet(positions).count() < unmet(before).count() && soundness_.holds(positions) &&
		   better(assembly_, angleDefects(assembly_, positions), startDefects_);
}

} // namespace developable::detail
