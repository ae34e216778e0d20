// SPDX-License-Identifier: GPL-3.0-or-later
// shortest_steps.cpp: whether a surface is all but developable, and the steps that are left.
#include "shortest_steps.h"

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
	for (int i = 0; i < tuning.shortestSteps && !run_.shape().reached; ++i) {
		if (!run_.mayGoOn())
			return Ending::Stopped;
		if (!run_.takeStep())
			return Ending::Stuck;
		problem_.jacobian().linearize(run_.shape().positions);
		const Positions whole = step(epsilon);
		const double squared = run_.shape().squaredDefects();
		const double length = run_.descendDefects(whole, 0, farthest_);
		const double left = run_.shape().squaredDefects() / squared;
		if (length == 0 && i == 0 && whole.colwise().norm().maxCoeff() > farthest_)
			return Ending::Stuck;
		epsilon *= length == 0                ? tuning.normalRetry
				   : left < tuning.normalGood ? tuning.normalFastDecrease
											  : 1;
	}
	return run_.shape().reached ? Ending::Reached : Ending::Stuck;
}

/// Moving all its places so far might just take a copy's angle defect away.
bool ShortestSteps::withinReach() const {
	const Eigen::VectorXd most = problem_.jacobian().greatestChange(farthest_);
	return (run_.shape().scaledDefects.cwiseAbs().array() <= most.array()).all();
}

Positions ShortestSteps::step(double epsilon) {
	const DefectJacobian& jacobian = problem_.jacobian();
	if (!solver_.factorize(problem_.jacobian().massProduct(epsilon)))
		return Positions::Zero(3, problem_.assembly().placeCount());
	const Eigen::VectorXd multipliers = solver_.solve(run_.shape().scaledDefects);
	return -jacobian.applyTransposed(multipliers) * inverseMass_.asDiagonal();
}

} // namespace developable::detail
