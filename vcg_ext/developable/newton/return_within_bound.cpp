// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.cpp: heavier places, steps towards the original and restorations, round by round.
#include "return_within_bound.h"

#include "pull_back.h"
#include "restoration.h"

namespace developable::detail {

ReturnWithinBound::ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound)
	: problem_(problem), run_(run), steps_(steps), bound_(bound), masses_(problem.metric().placeMass()),
	  weights_(Eigen::ArrayXd::Ones(masses_.size())), found_(run.shape()) {}

Ending ReturnWithinBound::run() {
	if (found_.farthest > problem_.tuning().returnReach * bound_)
		return Ending::Stuck;
	steps_.beginToStiffen();
	const Ending ending = goNearer();
	run_.goBackTo(found_);
	return ending;
}

Ending ReturnWithinBound::goNearer() {
	const NewtonTuning& tuning = problem_.tuning();
	double epsilon = dearCurvature();
	for (int rounds = 0, idle = 0; rounds < tuning.returnRounds && idle < tuning.returnPatience; ++rounds) {
		const double before = found_.farthest;
		const Ending ending = round(epsilon);
		if (ending != Ending::Reached && ending != Ending::Stuck)
			return ending;
		const double now = run_.shape().farthest;
		const bool nearer = ending == Ending::Reached && now < before;
		idle = nearer && now < (1 - tuning.returnGain) * before ? 0 : idle + 1;
		if (nearer)
			found_ = run_.shape();
		else
			epsilon *= tuning.returnDecrease;
		if (found_.farthest <= bound_)
			return Ending::Reached;
	}
	return Ending::Stuck;
}

/// With this ε, to bring back a share of the original's curvature is as dear as the whole displacement.
double ReturnWithinBound::dearCurvature() const {
	const Shape original = problem_.shapeAt(problem_.assembly().originalPositions);
	const double share = problem_.tuning().returnCurvature;
	return share * share * original.squaredDefects() / steps_.squaredDistance(found_);
}

Ending ReturnWithinBound::round(double epsilon) {
	run_.goBackTo(found_);
	steps_.loosen();
	makeFarPlacesHeavier();
	if (!problem_.metric().factorize())
		return Ending::Unsolvable;
	const Ending ending = approachOriginal(epsilon);
	if (ending != Ending::Settled)
		return ending;
	goBackWithin(problem_, run_, problem_.tuning().returnAim * bound_);
	const double first = problem_.tuning().returnRestoration * steps_.greatestResponse();
	return Restoration(problem_, run_, steps_, first).restore();
}

Ending ReturnWithinBound::approachOriginal(double epsilon) {
	double length = 1;
	for (int i = 0; i < problem_.tuning().returnSteps && length > 0; ++i) {
		if (!run_.takeStep())
			return Ending::OutOfSteps;
		steps_.forgetMultipliers();
		length = steps_.step(1, epsilon);
		if (steps_.stopped())
			return Ending::Stopped;
		if (steps_.unsolvable())
			return Ending::Unsolvable;
	}
	return Ending::Settled;
}

void ReturnWithinBound::makeFarPlacesHeavier() {
	constexpr double least = 1e-3; // of the largest: so that none is without weight for ever
	const Positions displacement = found_.positions - problem_.assembly().originalPositions;
	weights_ *= least + displacement.colwise().norm().transpose().array() / found_.farthest;
	weights_ /= weights_.maxCoeff();
	const NewtonTuning& tuning = problem_.tuning();
	const bool pullAtEachOther = problem_.assembly().isSewn();
	const double heaviest = pullAtEachOther ? tuning.returnWeightTogether : tuning.returnWeight;
	const Eigen::VectorXd masses = problem_.metric().placeMass().array() * (1 + heaviest * weights_);
	problem_.weigh(masses - masses_);
	masses_ = masses;
}

Ending returnToPreferred(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps) {
	const Shape found = run.shape();
	const double preferred = problem.preferredMove();
	Ending ending = ReturnWithinBound(problem, run, steps, preferred).run();
	if (ending == Ending::Stopped)
		return ending;
	if (ending != Ending::Reached && run.shape().farthest < found.farthest)
		ending = pullBackWithin(problem, run, preferred);
	if (ending == Ending::Stopped)
		return ending;
	if (!problem.hardlyFarther(run.shape(), found))
		run.goBackTo(found);
	return Ending::Reached;
}

Ending withinPreferred(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, const WorkBudget& begin) {
	const ExtraWork extra = workWithinPreferred(problem, begin);
	const Ending pulledBack = pullBackWithinPreferred(problem, run);
	return pulledBack == Ending::Stuck ? returnToPreferred(problem, run, steps) : pulledBack;
}

} // namespace developable::detail
