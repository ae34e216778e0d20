// SPDX-License-Identifier: GPL-3.0-or-later
// restoration_within_bound.cpp: rounds of pulling back and restoring.
#include "restoration_within_bound.h"

#include "pull_back.h"
#include "restoration.h"

namespace developable::detail {

namespace {

/// Makes places heavier for some time.
class HeavyPlaces {
public:
	explicit HeavyPlaces(NewtonProblem& problem) : problem_(problem), before_(problem.metric().weight()) {}
	HeavyPlaces(const HeavyPlaces&) = delete;
	HeavyPlaces& operator=(const HeavyPlaces&) = delete;

	/// As before. Memory may be missing for it: no matter of a destructor.
	void lighten() { problem_.setWeight(before_); }

	/// By how near each is to a bound, and by more in every round: with the same weight the last hundredths
	/// of the way would take ever smaller steps. \return whether the metric can be factorised then
	bool weigh(const Shape& shape, double bound) {
		const NewtonTuning& tuning = problem_.tuning();
		const Eigen::ArrayXd nearness =
			((shape.positions - problem_.assembly().originalPositions).colwise().norm() / bound).transpose();
		const Eigen::VectorXd more = increase_ * tuning.boundWeight * problem_.metric().placeMass().array() *
									 nearness.min(1).pow(tuning.boundSharpness);
		increase_ *= tuning.boundWeightIncrease;
		problem_.setWeight(before_ + more);
		return problem_.metric().factorize();
	}

private:
	NewtonProblem& problem_;
	const Eigen::VectorXd before_;
	double increase_ = 1;
};

Ending restoreHeavily(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound,
					  HeavyPlaces& heavy) {
	const NewtonTuning& tuning = problem.tuning();
	const double epsilon = tuning.returnRestoration * steps.greatestResponse();
	std::optional<Shape> found;
	if (run.shape().reached)
		found = run.shape();
	Ending ending = Ending::Stuck;
	for (int round = 0; round < tuning.boundRounds; ++round) {
		const bool beyond = run.shape().farthest > bound;
		if (found && !beyond)
			return Ending::Reached;
		if (beyond && !goBackWithin(problem, run, tuning.boundAim * bound))
			break;
		ending = heavy.weigh(run.shape(), bound) ? Restoration(problem, run, steps, epsilon).restore()
												 : Ending::Unsolvable;
		if (ending == Ending::Stopped)
			return ending;
		if (ending != Ending::Reached || (found && run.shape().farthest >= found->farthest))
			break;
		found = run.shape();
	}
	if (!found)
		return ending;
	run.goBackTo(*found);
	return Ending::Reached;
}

} // namespace

Ending restoreWithin(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double bound) {
	HeavyPlaces heavy(problem);
	const Ending ending = restoreHeavily(problem, run, steps, bound, heavy);
	heavy.lighten();
	return problem.metric().factorize() ? ending : Ending::Unsolvable;
}

} // namespace developable::detail
