// SPDX-License-Identifier: GPL-3.0-or-later
// newton_part.cpp: all patches of a part, then those that are left without the worst.
#include "newton_part.h"

#include "border_separation.h"
#include "closer_shapes.h"
#include "displacement_metric.h"
#include "frozen_panels.h"
#include "least_curvature.h"
#include "other_levels.h"

namespace developable::detail {

namespace {

/// Of the work, as far as one can tell: what all patches together take at first, and until some are frozen.
constexpr double shareOfFirst = 0.6, shareOfAllTogether = 0.8;

NewtonStrategy strategyFor(const ConstrainedNewtonOptions& options, const CurvatureGoal& goal) {
	return {options.smoothness,    options.fairness,    goal,
			options.maxIterations, options.memoryLimit, options.tuning};
}

NewtonOutcome solve(const PatchAssembly& part, const Positions& start, NewtonStrategy& strategy,
					const Progress& progress) {
	const bool mayFreeze = part.isSewn() && !holdsPlaces(part);
	const NewtonTuning& tuning = strategy.tuning();
	const double work = std::max(tuning.workPerPlace * part.placeCount(), tuning.workOnSmall);
	const double together = mayFreeze ? tuning.workTogether * work : work;
	const double extra = part.isSewn() ? together : tuning.preferredWorkPerPlace * part.placeCount();
	strategy.setBudget(std::make_shared<WorkBudget>(together, extra));
	OtherLevels others(part, start, strategy);
	if (others.any())
		strategy.leaveWaysBackToOthers();
	NewtonOutcome outcome = strategy.solve(
		part, start, others.beside(strategy.budget(), partOf(progress, 0, mayFreeze ? shareOfFirst : 1)));
	outcome.work = strategy.budget().used();
	if (outcome.ending == Ending::Stopped)
		return outcome;
	if (outcome.ending == Ending::OutOfSteps && strategy.budget().spent())
		outcome.ending = Ending::Stuck;
	if (!better(part, flatDefects(part, outcome.positions), flatDefects(part, start)))
		outcome.positions = start;
	if (outcome.ending != Ending::OutOfSteps)
		others.tryAll(outcome, partOf(progress, shareOfFirst, shareOfAllTogether, "another way: "));
	if (outcome.ending != Ending::Stuck || !mayFreeze)
		return outcome;
	strategy.setBudget(std::make_shared<WorkBudget>(tuning.workOfOthers * work, extra));
	const Progress progressOfOthers =
		partOf(progress, shareOfAllTogether, 1, "without panels that need a cut: ");
	outcome = FrozenPanels(part, start, strategy, progressOfOthers).finishOthers(std::move(outcome));
	outcome.work += strategy.budget().used();
	return outcome;
}

/// Within the goal's bound.
NewtonOutcome solveWithin(const PatchAssembly& part, const Positions& start,
						  const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
						  const Progress& progress) {
	NewtonStrategy strategy = strategyFor(options, goal);
	return solve(part, start, strategy, progress);
}

/// Steps that a bound cuts short often lead nowhere where panels that are sewn together pull at each other:
/// more of them end within one that is only preferred, and that is tried first.
NewtonOutcome solvePreferringFirst(const PatchAssembly& part, const Positions& start,
								   const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
								   const Progress& progress) {
	constexpr double shareOfPreferring = 0.5; // of the time
	CurvatureGoal usual = goal;
	usual.farthest = farthestAllowed(part, -1);
	NewtonStrategy strategy = strategyFor(options, usual);
	strategy.prefer(goal.farthest);
	NewtonOutcome outcome = solve(part, start, strategy, partOf(progress, 0, shareOfPreferring));
	const bool kept = farthestMove(part, outcome.positions) <= goal.farthest;
	if (outcome.ending == Ending::Stopped && !kept)
		outcome.positions = start;
	if (outcome.ending == Ending::Stopped || (outcome.ending == Ending::Reached && kept))
		return outcome;
	const double workBefore = outcome.work;
	outcome = solveWithin(part, start, options, goal, partOf(progress, shareOfPreferring, 1));
	outcome.work += workBefore;
	return outcome;
}

/// Without held places nothing else than the shape itself can stand in the way.
Status statusOf(Ending ending, const PatchAssembly& part) {
	switch (ending) {
	case Ending::Reached:
		return Status::Converged;
	case Ending::Settled:
	case Ending::Stuck:
	case Ending::TooFar:
		return holdsPlaces(part) ? Status::Stalled : Status::NeedsCut;
	case Ending::Unsolvable:
		return Status::Stalled;
	case Ending::OutOfSteps:
		return Status::LimitReached;
	case Ending::Stopped:
		return Status::Stopped;
	}
	return Status::Stalled;
}

bool anyFree(const PatchAssembly& part) {
	return std::find(part.placeFixed.begin(), part.placeFixed.end(), 0) != part.placeFixed.end();
}

} // namespace

PartOutcome solvePart(const PatchAssembly& part, const Positions& start,
					  const ConstrainedNewtonOptions& options, const Progress& progress) {
	constexpr double shareBefore = 0.8, shareCloser = 0.95; // of the time
	const double farthest = farthestAllowed(part, options.maxDisplacement);
	const CurvatureGoal goal{options.curvatureTolerance, options.angleTolerance, farthest};
	const bool startsNear = farthestMove(part, start) <= farthest;
	PartOutcome result;
	result.positions = startsNear ? start : part.originalPositions;
	if (goal.reached(part, flatDefects(part, result.positions)))
		return result;
	if (!anyFree(part)) {
		result.status = Status::Stalled;
		result.ending = Ending::Stuck;
		return result;
	}
	const bool isTight = farthest < farthestAllowed(part, -1) && part.isSewn() &&
						 part.placeCount() <= options.tuning.returnPlaces;
	NewtonOutcome outcome = (isTight ? solvePreferringFirst : solveWithin)(
		part, result.positions, options, goal, partOf(progress, 0, shareBefore));
	if (outcome.ending == Ending::Stuck && options.tuning.curvatureSteps > 0 && !holdsPlaces(part))
		lowerCurvature(part, result.positions, options, goal, outcome,
					   partOf(progress, shareBefore, 1, "what is left: "));
	// Of several panels the last may get there on the others' way.
	if (outcome.ending != Ending::Stopped && goal.reached(part, flatDefects(part, outcome.positions)))
		outcome.ending = Ending::Reached;
	if (outcome.ending == Ending::Reached)
		comeCloser(part, options, goal, outcome, partOf(progress, shareBefore, shareCloser, "closer: "));
	if (outcome.ending == Ending::Reached)
		separateBorders(part, options, goal, outcome, partOf(progress, shareCloser, 1, "moving apart: "));
	return {statusOf(outcome.ending, part), outcome.ending, outcome.iterations, std::move(outcome.positions),
			outcome.nearestDevelopable,     outcome.work};
}

} // namespace developable::detail
