// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.cpp: steps along the normals, with chords.
#include "normal_steps.h"

#include "local_steps.h"

namespace developable::detail {

NormalSteps::NormalSteps(NewtonProblem& problem, NewtonRun& run, double farthest)
	: problem_(problem), run_(run), farthest_(farthest), step_(problem) {}

void NormalSteps::allowLocalSteps() {
	const NewtonTuning& tuning = problem_.tuning();
	mayGoLocally_ = tuning.localRounds > 0 && problem_.assembly().placeCount() > tuning.localPlaces;
}

Ending NormalSteps::run() {
	const Shape begin = run_.shape();
	const Ending ending = go();
	if (ending != Ending::Stuck || !wentLocally_)
		return ending;
	run_.goBackTo(begin);
	problem_.metric().loosen();
	mayGoLocally_ = false;
	epsilon_ = 0;
	return go();
}

Ending NormalSteps::go() {
	const NewtonTuning& tuning = problem_.tuning();
	for (int idle = 0; !run_.shape().reached;) {
		if (!run_.mayGoOn())
			return Ending::Stopped;
		if (taken_ == most_)
			return Ending::Stuck;
		if (!run_.takeCheapStep())
			return Ending::OutOfSteps;
		++taken_;
		const double before = squaredDefects();
		const double length = step_.factorize(run_.shape(), {}, epsilon_) ? stepsWithOneFactorization() : 0;
		const double share = squaredDefects() / before;
		idle = share > tuning.normalIdle ? idle + 1 : 0;
		if (idle == tuning.normalPatience)
			return Ending::Stuck;
		epsilon_ *= epsilonFactor(share, length);
	}
	return Ending::Reached;
}

/// Smaller after a full step, the more so the more it removed; larger where the step had to be cut short.
double NormalSteps::epsilonFactor(double shareLeft, double length) const {
	const NewtonTuning& tuning = problem_.tuning();
	if (shareLeft < (mayGoLocally_ && wentLocally_ ? tuning.localGood : tuning.normalGood))
		return shareLeft < tuning.normalVeryGood ? tuning.normalFastDecrease : tuning.normalDecrease;
	if (length == 0)
		return tuning.normalRetry;
	if (length == 1)
		return tuning.normalSlowDecrease;
	return length < tuning.normalShortStep ? tuning.normalIncrease : 1;
}

double NormalSteps::stepWithLocalSteps() {
	if (!mayGoLocally_)
		return 0;
	const double length =
		LocalSteps(problem_, farthest_).step(run_, step_.whole(), problem_.tuning().normalGood);
	wentLocally_ = wentLocally_ || length > 0;
	return length;
}

double NormalSteps::stepsWithOneFactorization() {
	double length = stepWithLocalSteps();
	if (length == 0)
		length = run_.descendDefects(step_.whole(), problem_.tuning().normalHalvings, farthest_);
	if (length > 0)
		run_.takeChords([&] { return run_.mayGoOn() ? step_.chord(run_.shape()) : Positions(); }, farthest_);
	return length;
}

} // namespace developable::detail
