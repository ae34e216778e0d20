// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.cpp: heavier places, round by round.
#include "return_within_bound.h"

#include "continuation.h"
#include "restoration.h"

namespace developable::detail {

ReturnWithinBound::ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound)
	: problem_(problem), run_(run), steps_(steps), bound_(bound), masses_(problem.metric().placeMass()),
	  nearest_(run.shape().farthest) {}

Ending ReturnWithinBound::run() {
	const NewtonTuning& tuning = problem_.tuning();
	if (nearest_ > tuning.returnReach * bound_)
		return Ending::Stuck;
	steps_.beginToStiffen();
	makeFarPlacesHeavier();
	for (int i = 0; i < tuning.returnRounds; ++i) {
		const Ending ending = round();
		if (ending != Ending::Reached && ending != Ending::Stuck)
			return ending;
		if (ending == Ending::Reached && run_.shape().farthest <= bound_)
			return Ending::Reached;
		if (problem_.metric().tooStiff())
			return Ending::Stuck;
		if (ending == Ending::Stuck) {
			makeLighter();
		} else {
			if (run_.shape().farthest > tuning.returnProgress * nearest_ && i > 0)
				return Ending::Stuck;
			makeFarPlacesHeavier();
		}
	}
	return Ending::Stuck;
}

void ReturnWithinBound::makeFarPlacesHeavier() {
	nearest_ = std::min(nearest_, run_.shape().farthest);
	const Positions displacement = problem_.displacement(run_.shape());
	const double aim = problem_.tuning().returnAim * bound_;
	Eigen::VectorXd more = Eigen::VectorXd::Zero(masses_.size());
	for (int place = 0; place < masses_.size(); ++place) {
		const double share = displacement.col(place).norm() / aim;
		if (share > 1)
			more[place] = (std::pow(share, 16) - 1) * masses_[place];
	}
	masses_ += more;
	problem_.weigh(more);
}

/// Places much heavier than their neighbours may leave no way: half as much, as powers go.
void ReturnWithinBound::makeLighter() {
	const Eigen::VectorXd& own = problem_.metric().placeMass();
	const Eigen::VectorXd lighter = (masses_.array() * own.array()).sqrt();
	problem_.weigh(lighter - masses_);
	masses_ = lighter;
}

Ending ReturnWithinBound::round() {
	if (!problem_.metric().factorize())
		return Ending::Unsolvable;
	if (!run_.takeStep())
		return Ending::OutOfSteps;
	Continuation continuation(problem_, run_, steps_, problem_.tuning().returnEpsilon);
	steps_.forgetMultipliers();
	steps_.step(1, continuation.epsilon());
	if (steps_.stopped())
		return Ending::Stopped;
	const Ending ending = continuation.follow();
	if (ending != Ending::Settled && ending != Ending::Stuck)
		return ending;
	return Restoration(problem_, run_, steps_, continuation.epsilon()).restore();
}

} // namespace developable::detail
