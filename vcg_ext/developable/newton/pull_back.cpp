// SPDX-License-Identifier: GPL-3.0-or-later
// pull_back.cpp: shares of a displacement, pulled back, as starts of steps along the normals.
#include "pull_back.h"

#include "normal_steps.h"

namespace developable::detail {

namespace {

/// From where a run is to g = 0 within the bound, from the start again whenever more places are heavy.
Ending stepsWithin(NewtonProblem& problem, NewtonRun& run, double bound) {
	Eigen::VectorXd added = Eigen::VectorXd::Zero(problem.assembly().placeCount());
	Ending ending = Ending::Stuck;
	for (int round = 0; round < problem.tuning().pullBackRounds && ending == Ending::Stuck; ++round) {
		if (round > 0) {
			const Eigen::VectorXd more = weighPlacesAtBound(problem, run.shape(), bound);
			if (more.size() == 0)
				break;
			added += more;
			run.restart();
		}
		ending = NormalSteps(problem, run, bound).run();
	}
	problem.weigh(-added);
	return ending;
}

} // namespace

Eigen::VectorXd weighPlacesAtBound(NewtonProblem& problem, const Shape& shape, double bound) {
	const Eigen::VectorXd distances =
		(shape.positions - problem.assembly().originalPositions).colwise().norm();
	const NewtonTuning& tuning = problem.tuning();
	Eigen::VectorXd more = (distances.array() > tuning.returnAim * bound)
							   .select(tuning.heavyPlace * problem.metric().placeMass(), 0);
	if (more.maxCoeff() <= 0)
		return {};
	problem.weigh(more);
	return more;
}

Ending pullBackWithin(NewtonProblem& problem, NewtonRun& run, double bound) {
	const NewtonTuning& tuning = problem.tuning();
	const Positions& original = problem.assembly().originalPositions;
	const Positions displacement = run.shape().positions - original;
	if (run.shape().farthest > tuning.pullBackReach * bound)
		return Ending::Stuck;
	for (const double share : {1.0, tuning.pullBackShare}) {
		Positions move = share * displacement;
		pullBack(original, original, move, bound);
		if (!problem.soundness().spare(original, move))
			continue;
		NewtonRun back = run.elsewhere(original + move, tuning.pullBackSteps);
		const Ending ending = stepsWithin(problem, back, bound);
		if (ending == Ending::Reached)
			run.goBackTo(back.shape());
		if (ending == Ending::Reached || ending == Ending::Stopped)
			return ending;
	}
	return Ending::Stuck;
}

Ending pullBackWithinPreferred(NewtonProblem& problem, NewtonRun& run) {
	const Shape found = run.shape();
	if (found.farthest <= problem.preferredMove())
		return Ending::Reached;
	const Ending ending = pullBackWithin(problem, run, problem.preferredMove());
	if (ending != Ending::Reached || problem.hardlyFarther(run.shape(), found))
		return ending;
	run.goBackTo(found);
	return Ending::Stuck;
}

} // namespace developable::detail
