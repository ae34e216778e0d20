// SPDX-License-Identifier: GPL-3.0-or-later
// other_levels.cpp: one after the other, until one is near enough.
#include "other_levels.h"

#include "displacement_metric.h"

#include <cmath>

namespace developable::detail {

namespace {

/// Beside the usual coarsest level.
struct OtherLevel {
	double places, room; ///< shares of its places and of its room to move
};

/// Of 14 runs of sewn panels that went astray the first leads 6 to the end, the others 2 and 3 more.
constexpr OtherLevel otherLevels[] = {{0.6, 1}, {0.6, 0.8}, {1.5, 1}};

bool isNearer(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonOutcome& other) {
	if (outcome.ending != Ending::Reached || other.ending != Ending::Reached)
		return outcome.ending == Ending::Reached;
	return farthestMove(part, outcome.positions) < farthestMove(part, other.positions);
}

int placesOf(const OtherLevel& level, const NewtonTuning& tuning) {
	return static_cast<int>(std::lround(level.places * tuning.coarsestTogether));
}

NewtonStrategy strategyWith(const OtherLevel& level, const PatchAssembly& part, const NewtonStrategy& usual) {
	const NewtonTuning& tuning = usual.tuning();
	const double units = tuning.otherLevelWork * tuning.workPerPlace * part.placeCount();
	NewtonStrategy strategy = usual;
	strategy.beginWith(placesOf(level, tuning), level.room * tuning.coarseRoom);
	if (tuning.isCoarsest(part.placeCount(), tuning.fewestTogether()))
		strategy.coarsenFrom(placesOf(level, tuning));
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
	return tuning.otherLevels > 0 && part.patchCount() > 1 && !holdsPlaces(part) &&
		   part.placeCount() > tuning.fewestTogether() && part.placeCount() <= tuning.returnPlaces;
}

void tryOtherLevels(const PatchAssembly& part, const Positions& start, const NewtonStrategy& usual,
					NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = usual.tuning();
	constexpr double share = 1.0 / std::size(otherLevels); // of the time
	double begin = 0;
	for (const OtherLevel& level : otherLevels) {
		if (isWithinPreferred(part, outcome, tuning))
			return;
		const NewtonStrategy strategy = strategyWith(level, part, usual);
		if (strategy.tuning().isCoarsest(part.placeCount(), strategy.tuning().fewestTogether()))
			continue;
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
