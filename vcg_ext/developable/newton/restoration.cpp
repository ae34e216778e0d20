// SPDX-License-Identifier: GPL-3.0-or-later
// restoration.cpp: steps until they make no difference.
#include "restoration.h"

namespace developable::detail {

Restoration::Restoration(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double epsilon)
	: problem_(problem), run_(run), steps_(steps), epsilon_(epsilon) {}

Ending Restoration::restore() {
	for (int idle = 0; !run_.shape().reached;) {
		if (problem_.metric().tooStiff())
			return Ending::Stuck;
		if (!run_.takeStep())
			return Ending::OutOfSteps;
		const double before = run_.shape().scaledDefects.squaredNorm();
		steps_.forgetMultipliers();
		const double length = steps_.step(0, epsilon_);
		if (steps_.stopped())
			return Ending::Stopped;
		if (steps_.unsolvable())
			return Ending::Unsolvable;
		const double left = run_.shape().scaledDefects.squaredNorm() / before;
		idle = left > problem_.tuning().restorationIdle ? idle + 1 : 0;
		if (idle == problem_.tuning().restorationPatience)
			return Ending::Stuck;
		epsilon_ *= epsilonFactor(length);
	}
	return Ending::Reached;
}

double Restoration::epsilonFactor(double length) const {
	const NewtonTuning& tuning = problem_.tuning();
	if (length == 0)
		return tuning.restorationRetry;
	if (length == 1)
		return tuning.restorationDecrease;
	return length < tuning.restorationShortStep ? tuning.restorationIncrease : 1;
}

} // namespace developable::detail
