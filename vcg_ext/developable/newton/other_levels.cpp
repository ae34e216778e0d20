// SPDX-License-Identifier: GPL-3.0-or-later
// other_levels.cpp: one after the other, until one is near enough.
#include "other_levels.h"

#include "displacement_metric.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

/// Of the places of the usual coarsest level.
constexpr double shareOfPlaces = 0.6;
/// Of the shapes that developable ones are to be near, see NewtonStrategy. Of 14 runs of sewn panels that the
/// usual way leads astray these lead eight within the preferred move.
constexpr double fairnesses[] = {0.15, 0.08, 0};

/// Whether it is developable, and no place is farther than it had better move.
bool isWithinPreferred(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonTuning& tuning) {
	return outcome.ending == Ending::Reached &&
		   farthestMove(part, outcome.positions) <=
			   tuning.preferredBound(boxDiagonal(part.originalPositions));
}

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
	strategy.leaveWaysBackToOthers();
	strategy.setBudget(std::make_shared<WorkBudget>(units, units));
	return strategy;
}

} // namespace

bool mayTryOtherLevels(const PatchAssembly& part, const NewtonTuning& tuning) {
	constexpr double hardlyFewer = 0.9; // than a coarsest level has
	return tuning.otherLevels > 0 && part.isSewn() && !holdsPlaces(part) &&
		   part.placeCount() >= hardlyFewer * tuning.fewestTogether() &&
		   part.placeCount() <= tuning.returnPlaces;
}

OtherLevels::OtherLevels(const PatchAssembly& part, const Positions& start, const NewtonStrategy& usual)
	: part_(part), start_(start), tuning_(usual.tuning()) {
	if (!mayTryOtherLevels(part, tuning_))
		return;
	for (const double fairness : fairnesses) {
		if (static_cast<int>(ways_.size()) == tuning_.otherLevels)
			return;
		if (fairness > 0 && usual.isNearFairShape())
			continue;
		NewtonStrategy strategy = otherStrategy(fairness, part, usual);
		if (!strategy.tuning().isCoarsest(part.placeCount(), strategy.tuning().fewestTogether()))
			ways_.emplace_back(part, start, std::move(strategy));
	}
}

void OtherLevels::begin(std::size_t first, int count) {
	if (threadsAtHand() == 1)
		return;
	for (std::size_t way = first; way < std::min(ways_.size(), first + count); ++way)
		if (!ways_[way].task.begun())
			ways_[way].task.begin();
}

Progress OtherLevels::beside(const WorkBudget& budget, const Progress& progress) {
	const double patience = budget.used() + tuning_.workBeforeOthers * part_.placeCount();
	return [this, &budget, progress, patience](double fraction, const std::string& message) {
		if (budget.used() > patience)
			begin(0, 1);
		return mayGoOn(progress, fraction, message);
	};
}

NewtonOutcome OtherLevels::outcomeOf(Way& way, const Progress& progress) const {
	if (way.task.begun()) {
		way.task.finish(progress);
		return std::move(way.outcome);
	}
	return way.strategy.solve(part_, start_, progress);
}

void OtherLevels::tryAll(NewtonOutcome& outcome, const Progress& progress) {
	const auto count = double(ways_.size());
	for (std::size_t way = 0; way < ways_.size(); ++way) {
		if (isWithinPreferred(part_, outcome, tuning_))
			return;
		begin(way, threadsAtHand());
		NewtonOutcome next =
			outcomeOf(ways_[way], partOf(progress, double(way) / count, double(way + 1) / count));
		if (!outcome.goesOnWith(next, ways_[way].strategy.budget().used()))
			return;
		if (isNearer(part_, next, outcome))
			outcome = std::move(next);
	}
}

} // namespace developable::detail
