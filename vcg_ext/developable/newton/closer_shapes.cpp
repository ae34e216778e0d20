// SPDX-License-Identifier: GPL-3.0-or-later
// closer_shapes.cpp: bounds that shrink.
#include "closer_shapes.h"

#include "displacement_metric.h"
#include "gauss_newton.h"
#include "restoration_within_bound.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// Whether the farthest place is nearer, and by more than places are farther on average.
bool isCloser(const NewtonProblem& problem, const Shape& shape, const Shape& before) {
	const auto mean = [&](const Shape& one) {
		return displacementMap(problem.assembly().originalPositions, one.positions).mean();
	};
	return shape.farthest < before.farthest && shape.farthest * mean(shape) < before.farthest * mean(before);
}

/// Whether the farthest place is neither near enough nor too far away.
/// \param preferred  how far a place had better move, length
bool isWorthwhile(const NewtonTuning& tuning, const PatchAssembly& assembly, const Positions& positions,
				  double preferred) {
	const double farthest = farthestMove(assembly, positions);
	return tuning.closerRounds > 0 && farthest > tuning.closerFrom * preferred &&
		   farthest <= tuning.closerReach * preferred;
}

/// Ends with the run at the closest shape. \return as the last restoration ended
Ending shrinkBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps) {
	const NewtonTuning& tuning = problem.tuning();
	const double nearEnough = tuning.closerFrom * problem.preferredMove();
	Shape closest = run.shape();
	Ending ending = Ending::Reached;
	for (int round = 0; round < tuning.closerRounds && closest.farthest > nearEnough; ++round) {
		const double bound = std::max(nearEnough, tuning.closerStep * closest.farthest);
		ending = restoreWithin(problem, run, steps, bound);
		if (ending != Ending::Reached || !isCloser(problem, run.shape(), closest))
			break;
		closest = run.shape();
		if (closest.farthest > bound)
			break;
	}
	run.goBackTo(closest);
	return ending;
}

} // namespace

void comeCloser(NewtonProblem& problem, int maxIterations, NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = problem.tuning();
	if (!isWorthwhile(tuning, problem.assembly(), outcome.positions, problem.preferredMove()))
		return;
	NewtonRun run(problem, outcome.positions, maxIterations, progress);
	GaussNewton steps(problem, run, true, problem.goal().farthest);
	if (steps.unsolvable() || !run.shape().reached)
		return;
	if (shrinkBound(problem, run, steps) == Ending::Stopped)
		outcome.ending = Ending::Stopped;
	outcome.iterations += run.iterations();
	outcome.positions = run.shape().positions;
}

void comeCloser(const PatchAssembly& part, const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
				NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = options.tuning;
	if (!part.isSewn() || holdsPlaces(part) || part.placeCount() > tuning.returnPlaces ||
		!isWorthwhile(tuning, part, outcome.positions, preferredMove(part, tuning, goal)))
		return;
	NewtonProblem problem(part, goal, tuning, options.memoryLimit);
	problem.setBudget(std::make_shared<WorkBudget>(tuning.closerWorkPerPlace * part.placeCount()));
	problem.setSmoothness(options.smoothness);
	problem.jacobian().freeBorders(true);
	comeCloser(problem, options.maxIterations, outcome, progress);
	outcome.work += problem.budget().used();
}

} // namespace developable::detail
