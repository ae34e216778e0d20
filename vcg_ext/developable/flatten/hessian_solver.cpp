// SPDX-License-Identifier: GPL-3.0-or-later
// hessian_solver.cpp: when an old factor serves, and when there has to be a new one.
#include "hessian_solver.h"

namespace developable::detail {

bool HessianSolver::solve(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
						  Eigen::VectorXd& solution) {
	if (factorized_) {
		const Iterated iterated = solveWithOldFactor(matrix, rightHandSide, solution);
		if (iterated != Iterated::LimitOfSteps)
			return iterated == Iterated::Enough;
	}
	factorized_ = factor_.factorize(matrix);
	if (factorized_)
		solution = factor_.solve(rightHandSide);
	factorized_ = factorized_ && solution.dot(rightHandSide) > 0;
	return factorized_;
}

Iterated HessianSolver::solveWithOldFactor(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
										   Eigen::VectorXd& solution) const {
	constexpr int mostSteps = 12; // more cost as much as a new factor
	constexpr double tolerance = 1e-3;
	solution = Eigen::VectorXd::Zero(rightHandSide.size());
	double first = 0;
	const auto enough = [&](const Eigen::VectorXd&, double product) {
		if (first == 0)
			first = product;
		return product <= tolerance * tolerance * first;
	};
	return conjugateGradients(
		[&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
			return matrix.selfadjointView<Eigen::Lower>() * x;
		},
		[&](const Eigen::VectorXd& residual) { return factor_.solve(residual); }, rightHandSide, mostSteps,
		enough, [] { return true; }, solution);
}

} // namespace developable::detail
