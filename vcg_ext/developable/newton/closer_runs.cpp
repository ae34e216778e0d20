// SPDX-License-Identifier: GPL-3.0-or-later
// closer_runs.cpp: which bounds are tried, and what is taken.
#include "closer_runs.h"

#include "displacement_metric.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// How far the farthest places moved at least.
/// \param share  of all places, that these are
double leastOfFarthest(Eigen::VectorXd moves, double share) {
	const auto index = static_cast<Eigen::Index>(std::clamp(1 - share, 0.0, 1.0) * double(moves.size() - 1));
	std::nth_element(moves.data(), moves.data() + index, moves.data() + moves.size());
	return moves(index);
}

double largestBound(const PatchAssembly& part, const NewtonTuning& tuning) {
	return tuning.preferredMove * boxDiagonal(part.originalPositions);
}

/// The first of the bounds, from the largest, that is good, length.
/// \param isGood  says so of a bound
template <class IsGood>
double firstBound(const PatchAssembly& part, const NewtonTuning& tuning, const IsGood& isGood) {
	constexpr int most = 100; // next to nothing is left then
	double bound = largestBound(part, tuning);
	for (int step = 0; step < most && !isGood(bound); ++step)
		bound *= tuning.closerStep;
	return bound;
}

/// Whether the farthest place is nearer, and by more than places are farther on average.
bool isCloser(const Eigen::VectorXd& moves, const Eigen::VectorXd& others) {
	const double farthest = moves.maxCoeff(), before = others.maxCoeff();
	return farthest < before && farthest * moves.mean() < before * others.mean();
}

} // namespace

double boundWithin(const PatchAssembly& part, const NewtonTuning& tuning) {
	return firstBound(part, tuning, [&](double bound) { return bound <= tuning.preferredLength; });
}

bool mayComeCloser(const PatchAssembly& part, const NewtonTuning& tuning) {
	return part.isSewn() && tuning.closerTries > 0 && part.placeCount() <= tuning.returnPlaces;
}

void comeCloser(const PatchAssembly& part, const Positions& start, NewtonStrategy strategy,
				NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = strategy.tuning();
	Eigen::VectorXd moves = displacementMap(part.originalPositions, outcome.positions);
	const double few = leastOfFarthest(moves, tuning.closerPlaces);
	double bound = firstBound(part, tuning, [&](double next) { return tuning.closerStep * next < few; });
	const double nearEnough = tuning.closerFrom * largestBound(part, tuning);
	if (moves.maxCoeff() <= nearEnough || bound > tuning.closerGain * moves.maxCoeff())
		return;
	const double work = tuning.closerWorkPerPlace * part.placeCount();
	strategy.giveUpBeyondPreferred();
	bool wasKept = false;
	for (int tries = 0; tries < tuning.closerTries && bound < moves.maxCoeff(); ++tries) {
		strategy.setBudget(std::make_shared<WorkBudget>(work, work));
		strategy.prefer(bound);
		const double begin = double(tries) / tuning.closerTries, end = double(tries + 1) / tuning.closerTries;
		NewtonOutcome closer = strategy.solve(part, start, partOf(progress, begin, end));
		if (!outcome.goesOnWith(closer, strategy.budget().used()))
			return;
		const Eigen::VectorXd now = displacementMap(part.originalPositions, closer.positions);
		const bool taken = closer.ending == Ending::Reached && isCloser(now, moves);
		const bool kept = taken && now.maxCoeff() <= bound;
		if (taken) {
			moves = now;
			outcome = std::move(closer);
		}
		if (wasKept && !kept)
			return;
		wasKept = wasKept || kept;
		bound *= wasKept ? tuning.closerStep : 1 / tuning.closerStep;
	}
}

} // namespace developable::detail
