// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.cpp: heavier places, round by round.
#include "return_within_bound.h"

namespace developable::detail {

ReturnWithinBound::ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps,
									 double epsilon)
	: problem_(problem), run_(run), steps_(steps), epsilon_(epsilon), masses_(problem.metric().placeMass()),
	  nearest_(run.shape().farthest) {}

Ending ReturnWithinBound::run() {
	const NewtonTuning& tuning = problem_.tuning();
	for (int i = 0, idle = 0; i < tuning.returnRounds && idle < 2; ++i) {
		if (nearest_ > tuning.returnReach * problem_.goal().farthest)
			return Ending::Stuck;
		makeFarPlacesHeavier();
		const Ending ending = round();
		if (ending != Ending::Reached)
			return ending;
		if (!run_.farOff())
			return Ending::Reached;
		idle = run_.shape().farthest > tuning.returnProgress * nearest_ ? idle + 1 : 0;
		nearest_ = std::min(nearest_, run_.shape().farthest);
	}
	return Ending::Stuck;
}

void ReturnWithinBound::makeFarPlacesHeavier() {
	const Positions displacement = problem_.displacement(run_.shape());
	const double aim = problem_.tuning().returnAim * problem_.goal().farthest;
	Eigen::VectorXd more = Eigen::VectorXd::Zero(masses_.size());
	for (int place = 0; place < masses_.size(); ++place) {
		const double share = displacement.col(place).norm() / aim;
		if (share > 1)
			more[place] = (share * share * share * share - 1) * masses_[place];
	}
	masses_ += more;
	problem_.metric().weigh(more);
}

Ending ReturnWithinBound::round() {
	if (!problem_.metric().factorize())
		return Ending::Unsolvable;
	Ending ending = step(1, epsilon_);
	double epsilon = epsilon_;
	for (int i = 0; ending == Ending::Settled && i < problem_.tuning().returnSteps; ++i) {
		if (run_.shape().reached)
			return Ending::Reached;
		ending = step(0, epsilon);
		epsilon *= problem_.tuning().restorationDecrease;
	}
	if (ending != Ending::Settled)
		return ending;
	return run_.shape().reached ? Ending::Reached : Ending::Stuck;
}

/// \return Settled, where it may go on
Ending ReturnWithinBound::step(double tau, double epsilon) {
	if (!run_.takeStep())
		return Ending::OutOfSteps;
	steps_.forgetMultipliers();
	steps_.step(tau, epsilon);
	if (steps_.stopped())
		return Ending::Stopped;
	return steps_.unsolvable() ? Ending::Unsolvable : Ending::Settled;
}

} // namespace developable::detail
