// SPDX-License-Identifier: GPL-3.0-or-later
// restoration.cpp: steps until they make no difference.
#include "restoration.h"

namespace developable::detail {

Restoration::Restoration(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double epsilon)
	: problem_(problem), run_(run), steps_(steps), epsilon_(epsilon),
	  least_(problem.tuning().restorationLeast * steps.greatestResponse()) {}

Ending Restoration::restore() {
	std::vector<double> squares; // |g|² before each step
	for (int idle = 0; !run_.shape().reached;) {
		if (problem_.metric().tooStiff())
			return Ending::Stuck;
		if (!run_.takeStep())
			return Ending::OutOfSteps;
		const double before = run_.shape().squaredDefects();
		squares.push_back(before);
		steps_.forgetMultipliers();
		const double length = steps_.step(0, epsilon_);
		if (length == 1)
			steps_.chords(epsilon_);
		if (steps_.stopped())
			return Ending::Stopped;
		if (steps_.unsolvable())
			return Ending::Unsolvable;
		const double left = run_.shape().squaredDefects() / before;
		if (heldUp(length, left))
			yieldMore();
		idle = left > problem_.tuning().restorationIdle ? idle + 1 : 0;
		if (idle == problem_.tuning().restorationPatience || crawls(squares))
			return Ending::Stuck;
		epsilon_ = std::max(epsilon_ * restorationFactor(length, problem_.tuning()), least_);
	}
	return Ending::Reached;
}

/// The least ε and a whole step, and yet much is left: angle defects among stiff triangles or heavy places
/// hardly respond.
bool Restoration::heldUp(double length, double left) const {
	return length == 1 && left > problem_.tuning().restorationSlow && epsilon_ <= least_;
}

/// What is left to do is so little by now that triangles can go without being stiff, and steps do no harm
/// that are less true.
void Restoration::yieldMore() {
	const NewtonTuning& tuning = problem_.tuning();
	steps_.loosen();
	least_ = std::max(tuning.restorationDecrease * least_,
					  tuning.restorationLeastHeldUp * steps_.greatestResponse());
}

/// Slow steps in between are usual, but as many as this have hardly ever led to zero: something is in the
/// way.
bool Restoration::crawls(const std::vector<double>& squares) const {
	const std::size_t review = problem_.tuning().restorationReview;
	return squares.size() >= review &&
		   run_.shape().squaredDefects() > problem_.tuning().restorationSlow * squares.end()[-int(review)];
}

double restorationFactor(double length, const NewtonTuning& tuning) {
	if (length == 0)
		return tuning.restorationRetry;
	if (length == 1)
		return tuning.restorationDecrease;
	return length < tuning.restorationShortStep ? tuning.restorationIncrease : 1;
}

} // namespace developable::detail
