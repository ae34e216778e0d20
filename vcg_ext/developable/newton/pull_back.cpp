// SPDX-License-Identifier: GPL-3.0-or-later
// pull_back.cpp: shares of a displacement, pulled back, as starts of steps along the normals.
#include "pull_back.h"

#include "normal_steps.h"

namespace developable::detail {

namespace {

/// Steps push places against a bound that others could go without: makes those heavy.
/// \return whether there are any
bool weighPlacesAtBound(NewtonProblem& problem, const Shape& shape, double bound) {
	const Eigen::VectorXd distances =
		(shape.positions - problem.assembly().originalPositions).colwise().norm();
	const NewtonTuning& tuning = problem.tuning();
	const Eigen::VectorXd more = (distances.array() > tuning.returnAim * bound)
									 .select(tuning.heavyPlace * problem.metric().placeMass(), 0);
	problem.weigh(more);
	return more.maxCoeff() > 0;
}

/// Places; panels that pull at each other are kept from going far by nothing else.
int mostToReturn(const NewtonProblem& problem) {
	const NewtonTuning& tuning = problem.tuning();
	return problem.assembly().isSewn() ? tuning.returnPlacesTogether : tuning.returnPlaces;
}

} // namespace

bool goBackWithin(NewtonProblem& problem, NewtonRun& run, double bound) {
	const Positions from = run.shape().positions;
	Positions move = Positions::Zero(3, from.cols());
	pullBack(problem.assembly().originalPositions, from, move, bound);
	const bool sound = problem.soundness().spare(from, move);
	if (sound)
		run.goBackTo(problem.shapeAt(from + move));
	return sound;
}

Ending stepsWithin(NewtonProblem& problem, NewtonRun& run, double bound, int rounds) {
	std::optional<Shape> best; // heavy places may be in the way of more than they lead to
	for (int round = 1;; ++round) {
		NormalSteps steps(problem, run, bound);
		if (rounds > 1)
			steps.allowLocalSteps();
		const Ending ending = steps.run();
		if (!best || run.shape().squaredDefects() < best->squaredDefects())
			best = run.shape();
		if (ending == Ending::Stuck && round < rounds && weighPlacesAtBound(problem, run.shape(), bound)) {
			run.restart();
			continue;
		}
		if (ending != Ending::Reached)
			run.goBackTo(*best);
		return ending;
	}
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
		const Eigen::VectorXd weights = problem.metric().weight();
		const Ending ending = stepsWithin(problem, back, bound, tuning.pullBackRounds);
		problem.setWeight(weights);
		if (ending == Ending::Reached)
			run.goBackTo(back.shape());
		if (ending == Ending::Reached || ending == Ending::Stopped)
			return ending;
	}
	return Ending::Stuck;
}

bool isSmallEnoughToReturn(const NewtonProblem& problem) {
	return problem.assembly().placeCount() <= mostToReturn(problem);
}

ExtraWork workWithinPreferred(NewtonProblem& problem, const WorkBudget& begin) {
	const NewtonTuning& tuning = problem.tuning();
	const bool pullAtEachOther = problem.assembly().isSewn();
	const double size = double(problem.assembly().placeCount()) / mostToReturn(problem);
	const double onLarge = (pullAtEachOther ? tuning.preferredWork : 1) / size;
	const double onSmall = pullAtEachOther ? std::numeric_limits<double>::infinity() : tuning.preferredWork;
	return {problem.budget(), size > 1 ? onLarge : onSmall, begin};
}

bool mayBePreferred(const NewtonProblem& problem, const Shape& shape) {
	const NewtonTuning& tuning = problem.tuning();
	const double bound = problem.preferredMove();
	if (shape.farthest > tuning.preferredReach * bound)
		return false;
	const Positions& original = problem.assembly().originalPositions;
	Positions move = shape.positions - original;
	pullBack(original, original, move, bound);
	return problem.shapeAt(original + move).curvature <=
		   tuning.preferredCurvature * problem.shapeAt(original).curvature;
}

Ending pullBackWithinPreferred(NewtonProblem& problem, NewtonRun& run) {
	const Shape found = run.shape();
	if (found.farthest <= problem.preferredMove() || !mayBePreferred(problem, found))
		return Ending::Reached;
	const Ending ending = pullBackWithin(problem, run, problem.preferredMove());
	if (ending == Ending::Stopped || (ending == Ending::Reached && problem.hardlyFarther(run.shape(), found)))
		return ending;
	run.goBackTo(found);
	return isSmallEnoughToReturn(problem) ? Ending::Stuck : Ending::Reached;
}

} // namespace developable::detail
