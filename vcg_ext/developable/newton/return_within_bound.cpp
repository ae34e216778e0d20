// SPDX-License-Identifier: GPL-3.0-or-later
// return_within_bound.cpp: nearer bounds, heavy places and restorations, round by round.
#include "return_within_bound.h"

#include "restoration.h"

namespace developable::detail {

ReturnWithinBound::ReturnWithinBound(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound)
	: problem_(problem), run_(run), steps_(steps), bound_(bound), masses_(problem.metric().placeMass()),
	  found_(run.shape()) {}

Ending ReturnWithinBound::run() {
	const NewtonTuning& tuning = problem_.tuning();
	if (found_.farthest > tuning.returnReach * bound_)
		return Ending::Stuck;
	steps_.beginToStiffen();
	double share = tuning.returnStep;
	for (int left = tuning.returnRounds; left > 0 && share >= tuning.returnLeastStep; --left) {
		steps_.loosen();
		const double before = found_.farthest;
		const Ending ending = round(std::max(tuning.returnAim * bound_, (1 - share) * before));
		if (ending != Ending::Reached && ending != Ending::Stuck)
			return ending;
		const double now = run_.shape().farthest;
		if (ending == Ending::Stuck || now >= before) {
			share /= 2;
			continue;
		}
		found_ = run_.shape();
		if (now <= bound_)
			return Ending::Reached;
		// At this pace the bound is out of reach.
		if (std::log(bound_ / now) < left * std::log(now / before))
			return Ending::Stuck;
	}
	return Ending::Stuck;
}

Ending ReturnWithinBound::round(double aim) {
	makeFarPlacesHeavy(aim);
	if (!problem_.metric().factorize())
		return Ending::Unsolvable;
	if (!pullBackTo(aim))
		return Ending::Stuck;
	const double epsilon = problem_.tuning().returnEpsilon * steps_.greatestResponse();
	return Restoration(problem_, run_, steps_, epsilon).restore();
}

bool ReturnWithinBound::pullBackTo(double bound) {
	Positions move = Positions::Zero(3, masses_.size());
	pullBack(problem_.assembly().originalPositions, found_.positions, move, bound);
	const bool sound = problem_.soundness().spare(found_.positions, move);
	if (sound)
		run_.goBackTo(problem_.shapeAt(found_.positions + move));
	return sound;
}

void ReturnWithinBound::makeFarPlacesHeavy(double aim) {
	const NewtonTuning& tuning = problem_.tuning();
	const Positions displacement = found_.positions - problem_.assembly().originalPositions;
	const Eigen::ArrayXd shares = displacement.colwise().norm().transpose().array() / aim;
	const Eigen::VectorXd masses = problem_.metric().placeMass().array() *
								   (1 + tuning.returnWeight * shares.min(tuning.returnHeaviest).pow(16));
	problem_.weigh(masses - masses_);
	masses_ = masses;
}

} // namespace developable::detail
