// SPDX-License-Identifier: GPL-3.0-or-later
// fine_level.cpp: within the preferred bound first, else beyond it.
#include "fine_level.h"

#include "displacement_metric.h"
#include "normal_steps.h"
#include "pull_back.h"
#include "restoration_within_bound.h"
#include "return_within_bound.h"

namespace developable::detail {

namespace {

/// The whole displacement, or as much of it as leaves the triangles in order and moves no place too far.
Positions soundStart(const NewtonProblem& problem, const Positions& displacement) {
	const Positions& original = problem.assembly().originalPositions;
	const double margin = 1 - 1e-12;
	const double farthest = displacement.colwise().norm().maxCoeff();
	double share = farthest > problem.goal().farthest ? margin * problem.goal().farthest / farthest : 1;
	for (int halving = 0; halving < 10; ++halving, share /= 2) {
		Positions start = original + share * displacement;
		if (farthestMove(problem.assembly(), start) <= problem.goal().farthest &&
			problem.soundness().holds(start))
			return start;
	}
	return original;
}

/// The whole displacement but for places that it would move farther than they had better and triangles that
/// it would spoil, or as much of it as that helps.
Shape sparedStart(const NewtonProblem& problem, const Positions& displacement) {
	const Positions& original = problem.assembly().originalPositions;
	double share = 1;
	for (int halving = 0; halving < 5; ++halving, share /= 2) {
		Positions move = share * displacement;
		pullBack(original, original, move, problem.preferredMove());
		if (problem.soundness().spare(original, move))
			return problem.shapeAt(original + move);
	}
	return problem.shapeAt(original);
}

/// Where steps that keep the preferred bound begin; nothing where that is out of reach.
/// \param start  where others begin
std::optional<Positions> preferredStart(const NewtonProblem& problem, const CoarseShape& coarse,
										const Positions& start) {
	const double preferred = problem.preferredMove();
	if (!coarse.developable)
		return {};
	if (!isSmallEnoughToReturn(problem)) {
		if (farthestMove(problem.assembly(), start) > preferred)
			return {};
		return start;
	}
	if (coarse.farthest > problem.tuning().pullBackReach * preferred)
		return {};
	const Shape whole = sparedStart(problem, coarse.displacement);
	const Shape smoothed = sparedStart(problem, coarse.displacement + coarse.smoothing);
	return smoothed.curvature < whole.curvature ? smoothed.positions : whole.positions;
}

/// Steps that keep the preferred bound leave little curvature, which a restoration removes. Where that may
/// follow they take half of the iterations at most: some creep at the bound.
Ending refineWithinPreferred(NewtonProblem& problem, NewtonRun& run, int maxIterations) {
	NormalSteps along(problem, run, problem.preferredMove());
	along.allowLocalSteps();
	if (isSmallEnoughToReturn(problem))
		along.takeAtMost(maxIterations / 2);
	const Ending ending = along.run();
	const bool near = run.shape().curvature < problem.tuning().nearlyThere * run.startCurvature();
	if (ending != Ending::Stuck || !near || !isSmallEnoughToReturn(problem))
		return ending;
	const ExtraWork extra = workWithinPreferred(problem);
	problem.forgetNormalSystem();
	GaussNewton steps(problem, run, true, problem.goal().farthest);
	if (steps.unsolvable())
		return Ending::Unsolvable;
	const Ending restored = restoreWithin(problem, run, steps, problem.preferredMove());
	return restored == Ending::Reached ? withinPreferred(problem, run, steps) : restored;
}

/// From a developable shape; the systems of rounds are factorised only where there will be any.
Ending returnWithinPreferred(NewtonProblem& problem, NewtonRun& run) {
	const ExtraWork extra = workWithinPreferred(problem);
	const Ending pulledBack = pullBackWithinPreferred(problem, run);
	if (pulledBack != Ending::Stuck)
		return pulledBack;
	problem.forgetNormalSystem();
	GaussNewton steps(problem, run, true, problem.goal().farthest);
	return steps.unsolvable() ? Ending::Reached : returnToPreferred(problem, run, steps);
}

/// As far as places may go, and back as far as that can be done.
Ending refineBeyondPreferred(NewtonProblem& problem, NewtonRun& run, int rounds) {
	const Ending ending = stepsWithin(problem, run, problem.goal().farthest, rounds);
	return ending == Ending::Reached ? returnWithinPreferred(problem, run) : ending;
}

} // namespace

NewtonOutcome solveFine(NewtonProblem& problem, const CoarseShape& coarse, int maxIterations,
						const Progress& progress) {
	const int rounds = coarse.developable ? 2 : 1;
	const Positions start = soundStart(problem, coarse.displacement);
	int before = 0;
	if (const std::optional<Positions> preferred = preferredStart(problem, coarse, start)) {
		NewtonRun run(problem, *preferred, maxIterations, progress);
		Ending ending = refineWithinPreferred(problem, run, maxIterations);
		bool ended = ending == Ending::Reached || ending == Ending::Stopped;
		if (!ended && run.shape().curvature < problem.tuning().goOnBeyond * run.startCurvature()) {
			ending = refineBeyondPreferred(problem, run, rounds);
			ended = true;
		}
		if (ended || problem.tuning().beyondPreferred == 0)
			return {ending, run.iterations(), run.nearest()};
		before = run.iterations();
	}
	NewtonRun run(problem, start, maxIterations - before, progress);
	const Ending ending = refineBeyondPreferred(problem, run, rounds);
	return {ending, before + run.iterations(), run.nearest()};
}

} // namespace developable::detail
