// SPDX-License-Identifier: GPL-3.0-or-later
// continuation.cpp: when ε falls, and when it has done its part.
#include "continuation.h"

namespace developable::detail {

Continuation::Continuation(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double share)
	: problem_(problem), run_(run), steps_(steps),
	  epsilon_(problem.tuning().firstEpsilon * steps.greatestResponse()),
	  leastEpsilon_(problem.tuning().leastEpsilon * epsilon_) {
	epsilon_ *= share;
}

bool Continuation::weighFarPlaces() {
	const NewtonTuning& tuning = problem_.tuning();
	const Eigen::ArrayXd shares =
		problem_.displacement(run_.shape()).colwise().norm().transpose().array() / bound_;
	const Eigen::VectorXd& masses = problem_.metric().placeMass();
	const Eigen::VectorXd more =
		tuning.farPlace * masses.array() * shares.min(tuning.farMost).pow(tuning.farSharpness);
	problem_.setWeight(masses + more);
	return problem_.metric().factorize();
}

Ending Continuation::follow() {
	const NewtonTuning& tuning = problem_.tuning();
	while (!run_.shape().reached) {
		if (!run_.takeStep())
			return Ending::OutOfSteps;
		const double before = steps_.merit(run_.shape(), epsilon_);
		const double distanceBefore = steps_.squaredDistance(run_.shape());
		const double length = steps_.step(1, epsilon_);
		if (steps_.stopped())
			return Ending::Stopped;
		if (steps_.unsolvable())
			return Ending::Unsolvable;
		if (problem_.beyondWay(run_.shape()))
			return Ending::TooFar;
		if (length == 0 || problem_.metric().tooStiff())
			return Ending::Stuck;
		if (bound_ > 0 && !weighFarPlaces())
			return Ending::Unsolvable;
		// Stiffer triangles make φ larger, so that ε falls the sooner.
		const double decrease = 1 - steps_.merit(run_.shape(), epsilon_) / before;
		const double distance = steps_.squaredDistance(run_.shape());
		const bool settled = std::abs(distance - distanceBefore) < tuning.settledDistance * distanceBefore;
		if (run_.shape().curvature < tuning.settledCurvature * run_.startCurvature() && settled)
			return Ending::Settled;
		if ((length == 1 && decrease < tuning.slowDecrease) || decrease < tuning.noDecrease) {
			if (epsilon_ < leastEpsilon_)
				return Ending::Stuck;
			epsilon_ *= tuning.epsilonDecrease;
		}
	}
	return Ending::Reached;
}

} // namespace developable::detail
