// SPDX-License-Identifier: GPL-3.0-or-later
// fair_descent.cpp: rounds of an aim, steps towards it and a restoration.
#include "fair_descent.h"

#include "gauss_newton.h"
#include "restoration.h"

namespace developable::detail {

FairDescent::FairDescent(const Unfairness& unfairness, double smoothness, const CurvatureGoal& goal,
						 int maxIterations, double memoryLimit, const NewtonTuning& tuning,
						 std::shared_ptr<WorkBudget> budget)
	: unfairness_(unfairness), smoothness_(smoothness), goal_(goal), maxIterations_(maxIterations),
	  memoryLimit_(memoryLimit), tuning_(tuning), budget_(std::move(budget)) {}

Ending FairDescent::run(Positions& positions, const Progress& progress) {
	least_ = unfairness_.at(positions);
	double length = 1;
	int idle = 0;
	for (int round = 0; round < tuning_.fairRounds; ++round) {
		const Progress ofRound =
			partOf(progress, double(round) / tuning_.fairRounds, double(round + 1) / tuning_.fairRounds);
		const Unfairness::Step step = unfairness_.step(positions);
		const double before = least_;
		std::optional<Positions> fairer;
		for (int halving = 0; !fairer && !stopped_ && halving <= tuning_.fairHalvings; ++halving) {
			length = halving == 0 ? std::min(1.0, 2 * length) : length / 2;
			fairer = along(step, length, positions, ofRound);
		}
		if (stopped_)
			return Ending::Stopped;
		if (!fairer)
			break;
		positions = *fairer;
		idle = least_ > (1 - tuning_.fairGain) * before ? idle + 1 : 0;
		if (idle == tuning_.fairPatience)
			break;
	}
	return Ending::Reached;
}

std::optional<Positions> FairDescent::along(const Unfairness::Step& step, double share, const Positions& from,
											const Progress& progress) {
	const PatchAssembly& original = unfairness_.original();
	PatchAssembly reference = original;
	reference.originalPositions = from + share * step.move;
	NewtonProblem problem(original, reference, goal_, tuning_, memoryLimit_, unfairness_.shapeSmoothness());
	problem.setBudget(budget_);
	problem.setSmoothness(smoothness_);
	problem.jacobian().freeBorders(true);
	problem.weigh(step.extraMasses);
	NewtonRun run(problem, from, maxIterations_, progress);
	const Ending ending = approach(problem, run);
	iterations_ += run.iterations();
	stopped_ = ending == Ending::Stopped;
	const double now = ending == Ending::Reached ? unfairness_.at(run.shape().positions) : least_;
	if (!(now < least_))
		return {};
	least_ = now;
	return run.shape().positions;
}

Ending FairDescent::approach(NewtonProblem& problem, NewtonRun& run) const {
	GaussNewton steps(problem, run, true, goal_.farthest);
	if (steps.unsolvable())
		return Ending::Unsolvable;
	for (int i = 0; i < tuning_.fairAimSteps && run.takeStep(); ++i) {
		steps.step(1, tuning_.fairEpsilon * steps.greatestResponse());
		if (steps.stopped())
			return Ending::Stopped;
		if (steps.unsolvable())
			return Ending::Unsolvable;
	}
	return Restoration(problem, run, steps, tuning_.fairRestoration * steps.greatestResponse()).restore();
}

} // namespace developable::detail
