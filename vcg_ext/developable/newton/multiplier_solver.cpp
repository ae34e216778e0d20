// SPDX-License-Identifier: GPL-3.0-or-later
// multiplier_solver.cpp: the operator and its preconditioner.
#include "multiplier_solver.h"

namespace developable::detail {

MultiplierSolver::MultiplierSolver(NewtonProblem& problem, int slow)
	: problem_(problem), factorization_(problem.memoryLimit()),
	  direct_(problem.memoryLimit(), problem.metric().eliminationOrder()), slowProducts_(slow) {}

Eigen::VectorXd MultiplierSolver::apply(const Eigen::VectorXd& multipliers) {
	const DefectJacobian& jacobian = problem_.jacobian();
	problem_.budget().spend(problem_.assembly().placeCount());
	++products_;
	return jacobian.apply(problem_.metric().solve(jacobian.applyTransposed(multipliers)));
}

double MultiplierSolver::findGreatestResponse(Eigen::VectorXd start) {
	for (int i = 0; i < problem_.tuning().responseSteps; ++i)
		start = apply(start.normalized());
	return greatestResponse_ = start.norm();
}

bool MultiplierSolver::solve(const Eigen::VectorXd& b, double epsilon, Eigen::VectorXd& y,
							 const std::function<bool()>& mayGoOn, Positions& response, bool foreseen) {
	if (slow_) {
		if (!mayGoOn())
			return false;
		if (solveDirectly(b, epsilon, foreseen && factorized_, response))
			return true;
		canFactorize_ = false;
		slow_ = false;
	}
	factorized_ = false;
	products_ = 0;
	if (iterate(b, epsilon, y, mayGoOn) == Iterated::Stopped)
		return false;
	slow_ = canFactorize_ && (products_ > slowProducts_ || preconditionerIsDear());
	response = problem_.metric().solve(problem_.jacobian().applyTransposed(y));
	return true;
}

bool MultiplierSolver::solveDirectly(const Eigen::VectorXd& b, double epsilon, bool foreseen,
									 Positions& response) {
	const SparseMatrix& metric = problem_.metric().matrix();
	const bool solved = foreseen ? direct_.solveForeseen(metric, problem_.jacobian(), b, epsilon, response)
								 : direct_.solve(metric, problem_.jacobian(), b, epsilon, response);
	if (direct_.factorizedLast())
		problem_.budget().spendOperations(direct_.operations());
	else
		problem_.budget().spend(double(problem_.tuning().foreseenWork) * problem_.assembly().placeCount());
	factorized_ = solved;
	return solved;
}

bool MultiplierSolver::factorize(double epsilon) {
	DefectJacobian& jacobian = problem_.jacobian();
	const SparseMatrix& k = jacobian.massProduct(problem_.tuning().slackMass * epsilon);
	if (!factorization_.prepared())
		factorization_.prepare(k, jacobian.rowOrder(problem_.metric().eliminationOrder()));
	problem_.budget().spendOperations(factorization_.operations());
	return factorization_.factorize(k);
}

/// K is dense where many triangles share a place or an edge.
bool MultiplierSolver::preconditionerIsDear() const {
	return factorization_.operations() >
		   problem_.tuning().dearPreconditioner * problem_.assembly().placeCount();
}

Iterated MultiplierSolver::iterate(const Eigen::VectorXd& b, double epsilon, Eigen::VectorXd& y,
								   const std::function<bool()>& mayGoOn) {
	const NewtonTuning& tuning = problem_.tuning();
	inverseMass_ = problem_.metric().weight().cwiseInverse();
	// Should rounding spoil K, plain conjugate gradients remain.
	const bool withPreconditioner = epsilon < tuning.plainAbove * greatestResponse_ && factorize(epsilon);
	const auto system = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return apply(x) + epsilon * x; };
	const auto precondition = [&](const Eigen::VectorXd& residual) {
		return withPreconditioner ? preconditioned(residual, epsilon) : residual;
	};
	const double residualAllowed = tuning.systemResidual * b.norm();
	const auto enough = [&](const Eigen::VectorXd& residual, double) {
		return residual.norm() <= residualAllowed;
	};
	return conjugateGradients(system, precondition, b, tuning.systemSteps, enough, mayGoOn, y);
}

Eigen::VectorXd MultiplierSolver::preconditioned(const Eigen::VectorXd& residual, double epsilon) const {
	const DefectJacobian& jacobian = problem_.jacobian();
	const double slack = problem_.tuning().slackMass;
	const Eigen::VectorXd u = factorization_.solve(residual);
	const Positions lifted = jacobian.applyTransposed(u) * inverseMass_.asDiagonal();
	const Eigen::VectorXd weighed =
		jacobian.apply(problem_.metric().apply(lifted) * inverseMass_.asDiagonal()) +
		epsilon * slack * slack * u;
	return factorization_.solve(weighed);
}

} // namespace developable::detail
