// SPDX-License-Identifier: GPL-3.0-or-later
// gauss_newton.cpp: the direction of a step, and the step along it.
#include "gauss_newton.h"

#include "local_steps.h"

namespace developable::detail {

GaussNewton::GaussNewton(NewtonProblem& problem, NewtonRun& run, bool stiffens, double farthest)
	: problem_(problem), run_(run), stiffens_(stiffens), farthest_(farthest),
	  solver_(problem, stiffens ? problem.tuning().slowStiffSystem : problem.tuning().slowSystem),
	  multipliers_(Eigen::VectorXd::Zero(problem.jacobian().rowCount())),
	  unsolvable_(!problem.metric().factorize()) {
	if (unsolvable_)
		return;
	problem_.jacobian().linearize(run.shape().positions);
	greatestResponse_ = solver_.findGreatestResponse(run.shape().scaledDefects);
}

void GaussNewton::loosen() {
	if (problem_.metric().loosen())
		unsolvable_ = !problem_.metric().factorize();
}

double GaussNewton::step(double tau, double epsilon) {
	problem_.jacobian().linearize(run_.shape().positions);
	Positions whole = direction(tau, epsilon);
	for (int i = 0; i < problem_.tuning().foresights && !stopped_; ++i) {
		if (!problem_.jacobian().foresee(run_.shape().positions, run_.shape().positions + whole))
			break;
		metLimits_ = true;
		whole = direction(tau, epsilon, true);
	}
	const int stiffenings = stiffens_ ? problem_.tuning().stiffenings : 0;
	for (int i = 0; i < stiffenings && !stopped_; ++i) {
		if (!problem_.stiffenFor(run_.shape().positions + whole))
			break;
		const bool spoilt = !problem_.metric().factorize();
		if (spoilt)
			loosen(); // rounding can't bear what they have become
		if (unsolvable_)
			return 0;
		whole = direction(tau, epsilon);
		if (spoilt)
			break;
	}
	if (stopped_)
		return 0;
	if (tau == 0) {
		const double length = LocalSteps(problem_, farthest_).step(run_, whole, 1);
		if (length > 0)
			return length;
	}
	const Positions displacement = problem_.displacement(run_.shape());
	const double slope = tau * problem_.metric().apply(displacement).cwiseProduct(whole).sum() +
						 problem_.jacobian().apply(whole).dot(run_.shape().scaledDefects) / epsilon;
	return run_.descend(
		whole, [&](const Shape& shape) { return merit(shape, tau, epsilon); }, slope,
		problem_.tuning().halvings, farthest_);
}

void GaussNewton::chords(double epsilon) {
	run_.takeChords([&] { return solver_.factorizedLast() ? direction(0, epsilon, true) : Positions(); },
					farthest_);
}

Positions GaussNewton::direction(double tau, double epsilon, bool foreseen) {
	const Positions displacement = problem_.displacement(run_.shape());
	const DefectJacobian& jacobian = problem_.jacobian();
	const Eigen::VectorXd rightHandSide =
		jacobian.linearResidual(run_.shape().scaledDefects) - tau * jacobian.apply(displacement);
	Positions response;
	stopped_ = !solver_.solve(
		rightHandSide, epsilon, multipliers_, [&] { return run_.mayGoOn(); }, response, foreseen);
	if (stopped_)
		return {};
	return -tau * displacement - response;
}

double GaussNewton::squaredDistance(const Shape& shape) const {
	return problem_.metric().squaredNorm(problem_.displacement(shape));
}

double GaussNewton::merit(const Shape& shape, double tau, double epsilon) const {
	const double distance = tau == 0 ? 0 : tau * squaredDistance(shape) / 2;
	return distance + shape.squaredDefects() / (2 * epsilon);
}

} // namespace developable::detail
