// SPDX-License-Identifier: GPL-3.0-or-later
// other_levels.cpp: one after the other, until one is near enough.
#include "other_levels.h"

#include "displacement_metric.h"

#include <cmath>

namespace developable::detail {

namespace {

/// Of the places of the usual coarsest level.
constexpr double shareOfPlaces = 0.6;
/// Of the shapes that developable ones are to be near, see NewtonStrategy. Of 14 runs of sewn panels that the
/// usual way leads astray these lead eight within the preferred move.
constexpr double fairnesses[] = {0.15, 0.08, 0};

bool isNearer(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonOutcome& other) {
	if (outcome.ending != Ending::Reached || other.ending != Ending::Reached)
		return outcome.ending == Ending::Reached;
	return farthestMove(part, outcome.positions) < farthestMove(part, other.positions);
}

NewtonStrategy otherStrategy(double fairness, const PatchAssembly& part, const NewtonStrategy& usual) {
	const NewtonTuning& tuning = usual.tuning();
	const double units = tuning.otherLevelWork * tuning.workPerPlace * part.placeCount();
	const int places = static_cast<int>(std::lround(shareOfPlaces * tuning.coarsestTogether));
	NewtonStrategy strategy = usual;
	strategy.beginWith(places);
	if (tuning.isCoarsest(part.placeCount(), tuning.fewestTogether()))
		strategy.coarsenFrom(places);
	if (fairness > 0)
		strategy.beginNearFairShape(fairness);
	strategy.giveUpBeyondPreferred();
	strategy.setBudget(std::make_shared<WorkBudget>(units, units));
	return strategy;
}

} // namespace

bool isWithinPreferred(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonTuning& tuning) {
	return outcome.ending == Ending::Reached &&
		   farthestMove(part, outcome.positions) <=
			   tuning.preferredBound(boxDiagonal(part.originalPositions));
}

bool mayTryOtherLevels(const PatchAssembly& part, const NewtonTuning& tuning) {
	constexpr double hardlyFewer = 0.9; // than a coarsest level has
	return tuning.otherLevels > 0 && part.patchCount() > 1 && !holdsPlaces(part) &&
		   part.placeCount() >= hardlyFewer * tuning.fewestTogether() &&
		   part.placeCount() <= tuning.returnPlaces;
}

void tryOtherLevels(const PatchAssembly& part, const Positions& start, const NewtonStrategy& usual,
					NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = usual.tuning();
	constexpr double share = 1.0 / std::size(fairnesses); // of the time
	double begin = 0;
	int left = tuning.otherLevels;
	for (const double fairness : fairnesses) {
		if (left == 0 || isWithinPreferred(part, outcome, tuning))
			return;
		if (fairness > 0 && usual.isNearFairShape())
			continue;
		const NewtonStrategy strategy = otherStrategy(fairness, part, usual);
		if (strategy.tuning().isCoarsest(part.placeCount(), strategy.tuning().fewestTogether()))
			continue;
		--left;
		NewtonOutcome next = strategy.solve(part, start, partOf(progress, begin, begin + share));
		begin += share;
		next.iterations = outcome.iterations += next.iterations;
		next.work = outcome.work += strategy.budget().used();
		if (next.ending == Ending::Stopped) {
			outcome.ending = Ending::Stopped;
			return;
		}
		if (isNearer(part, next, outcome))
			outcome = std::move(next);
	}
}

} // namespace developable::detail
