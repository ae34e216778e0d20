// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.cpp: steps along the normals, with chords.
#include "normal_steps.h"

#include "local_steps.h"

namespace developable::detail {

NormalSteps::NormalSteps(NewtonProblem& problem, NewtonRun& run, double farthest)
	: problem_(problem), run_(run), farthest_(farthest) {}

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
		if (!run_.takeCheapStep())
			return Ending::OutOfSteps;
		const double before = squaredDefects();
		const double length = factorize() ? stepsWithOneFactorization() : 0;
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

bool NormalSteps::factorize() {
	const Positions& positions = run_.shape().positions;
	const NewtonTuning& tuning = problem_.tuning();
	problem_.jacobian().linearize(positions);
	normals_ = placeNormals(problem_.assembly(), positions);
	along_ = problem_.jacobian().along(normals_);
	if (epsilon_ == 0) // normals are one long, so W and NᵀWN have the same trace
		epsilon_ = tuning.firstDamping * along_.squaredNorm() / problem_.metric().matrix().diagonal().sum();
	NormalSystem& system = problem_.normalSystem();
	for (int i = 0; system.factorize(along_, normals_, problem_.metric().matrix(), epsilon_); ++i) {
		problem_.budget().spendOperations(system.operations());
		problem_.budget().spend(problem_.assembly().placeCount());
		firstStep_ = wholeStep();
		if (i == tuning.stiffenings || problem_.metric().tooStiff() ||
			!problem_.stiffenFor(positions + firstStep_))
			return true;
	}
	return false;
}

Positions NormalSteps::wholeStep() const {
	const Eigen::VectorXd downward = -(along_.transpose() * run_.shape().scaledDefects);
	return normals_ * problem_.normalSystem().solve(downward).asDiagonal();
}

double NormalSteps::stepWithLocalSteps() {
	if (!mayGoLocally_)
		return 0;
	const double length =
		LocalSteps(problem_, farthest_).step(run_, firstStep_, problem_.tuning().normalGood);
	wentLocally_ = wentLocally_ || length > 0;
	return length;
}

double NormalSteps::stepsWithOneFactorization() {
	double length = stepWithLocalSteps();
	if (length == 0)
		length = run_.descendDefects(firstStep_, problem_.tuning().normalHalvings, farthest_);
	if (length > 0)
		run_.takeChords([&] { return run_.mayGoOn() ? wholeStep() : Positions(); }, farthest_);
	return length;
}

} // namespace developable::detail
