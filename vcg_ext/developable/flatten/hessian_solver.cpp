// SPDX-License-Identifier: GPL-3.0-or-later
// hessian_solver.cpp: when an old factor serves, and when there has to be a new one.
#include "hessian_solver.h"

#include <utility>

namespace developable::detail {

bool HessianSolver::solve(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
						  Eigen::VectorXd& solution) {
	if (factorized_ && conjugateGradients(matrix, rightHandSide, solution))
		return true;
	if (indefinite_)
		return false;
	factorized_ = factor_.factorize(matrix);
	if (factorized_)
		solution = factor_.solve(rightHandSide);
	factorized_ = factorized_ && solution.dot(rightHandSide) > 0;
	return factorized_;
}

bool HessianSolver::conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
									   Eigen::VectorXd& solution) {
	constexpr int mostSteps = 12; // more cost as much as a new factor
	constexpr double tolerance = 1e-3;
	solution = Eigen::VectorXd::Zero(rightHandSide.size());
	Eigen::VectorXd residual = rightHandSide, preconditioned = factor_.solve(residual);
	Eigen::VectorXd direction = preconditioned;
	double product = residual.dot(preconditioned);
	const double enough = tolerance * tolerance * product;
	indefinite_ = false;
	for (int step = 0; step < mostSteps; ++step) {
		const Eigen::VectorXd image = matrix.selfadjointView<Eigen::Lower>() * direction;
		const double curvature = direction.dot(image);
		if (!(curvature > 0)) {
			indefinite_ = true;
			return false;
		}
		solution += product / curvature * direction;
		residual -= product / curvature * image;
		preconditioned = factor_.solve(residual);
		const double last = std::exchange(product, residual.dot(preconditioned));
		if (product <= enough)
			return true;
		direction = preconditioned + product / last * direction;
	}
	return false;
}

} // namespace developable::detail
