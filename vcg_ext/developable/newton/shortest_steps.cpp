// SPDX-License-Identifier: GPL-3.0-or-later
// shortest_steps.cpp: whether a surface is all but developable, and the steps that are left.
#include "shortest_steps.h"

#include "developable/linear/linear.h"

namespace developable::detail {

ShortestSteps::ShortestSteps(NewtonProblem& problem, NewtonRun& run)
	: problem_(problem), run_(run), inverseMass_(problem.metric().placeMass().cwiseInverse()),
	  farthest_(
		  std::min(problem.goal().farthest,
				   problem.tuning().shortestMove *
					   edgeLengths(problem.assembly(), problem.assembly().originalPositions).minCoeff())),
	  solver_(problem.memoryLimit()) {}

Ending ShortestSteps::run() {
	const NewtonTuning& tuning = problem_.tuning();
	problem_.jacobian().linearize(run_.shape().positions);
	if (!withinReach())
		return Ending::Stuck;
	const SparseMatrix& product = problem_.jacobian().massProduct(0);
	double epsilon = tuning.shortestDamping * product.diagonal().mean();
	for (int i = 0, failed = 0; i < tuning.shortestSteps && !run_.shape().reached; ++i) {
		if (!run_.mayGoOn())
			return Ending::Stopped;
		if (!run_.takeStep())
			return Ending::Stuck;
		problem_.jacobian().linearize(run_.shape().positions);
		const Positions whole = step(epsilon);
		const double squared = run_.shape().squaredDefects();
		const double length = run_.descendDefects(whole, 0, farthest_);
		const double left = run_.shape().squaredDefects() / squared;
		failed = length == 0 ? failed + 1 : 0;
		if (failed == tuning.shortestPatience ||
			(failed > 0 && i == 0 && whole.colwise().norm().maxCoeff() > farthest_))
			return Ending::Stuck;
		epsilon *= length == 0                ? tuning.normalRetry
				   : left < tuning.normalGood ? tuning.normalFastDecrease
											  : 1;
	}
	return run_.shape().reached ? Ending::Reached : Ending::Stuck;
}

/// Whether moves so short might take all angle defects away. For any multipliers y, a move s with J s = -g
/// has |yᵀg| = |yᵀJ s| ≤ Σ |Jᵀy|ₚ |s|ₚ over the places p. Asked for y of one row each, and for those that
/// conjugate gradients go through on the way to J M⁻¹ Jᵀ y = g, which reach farther with every step.
bool ShortestSteps::withinReach() const {
	const Eigen::VectorXd& defects = run_.shape().scaledDefects;
	const DefectJacobian& jacobian = problem_.jacobian();
	if ((defects.cwiseAbs().array() > jacobian.greatestChange(farthest_).array()).any())
		return false;
	const auto apply = [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
		return jacobian.apply(jacobian.applyTransposed(y) * inverseMass_.asDiagonal());
	};
	Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(defects.size());
	const auto beyond = [&](const Eigen::VectorXd&, double) {
		const double most = farthest_ * jacobian.applyTransposed(multipliers).colwise().norm().sum();
		return multipliers.dot(defects) > most;
	};
	return conjugateGradients(
			   apply, [](const Eigen::VectorXd& residual) { return residual; }, defects,
			   problem_.tuning().shortestForesight, beyond, [] { return true; },
			   multipliers) != Iterated::Enough;
}

Positions ShortestSteps::step(double epsilon) {
	const DefectJacobian& jacobian = problem_.jacobian();
	if (!solver_.factorize(problem_.jacobian().massProduct(epsilon)))
		return Positions::Zero(3, problem_.assembly().placeCount());
	const Eigen::VectorXd multipliers = solver_.solve(run_.shape().scaledDefects);
	return -jacobian.applyTransposed(multipliers) * inverseMass_.asDiagonal();
}

} // namespace developable::detail
