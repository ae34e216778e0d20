// SPDX-License-Identifier: GPL-3.0-or-later
// multiplier_solver.cpp: conjugate gradients with the preconditioner of Elman.
#include "multiplier_solver.h"

namespace developable::detail {

Eigen::VectorXd MultiplierSolver::apply(const Eigen::VectorXd& multipliers) const {
	return jacobian_.apply(metric_.solve(jacobian_.applyTransposed(multipliers)));
}

double MultiplierSolver::findGreatestResponse(Eigen::VectorXd start) {
	for (int i = 0; i < 3; ++i)
		start = apply(start.normalized());
	return greatestResponse_ = start.norm();
}

bool MultiplierSolver::solve(const Eigen::VectorXd& b, double epsilon, double tolerance, Eigen::VectorXd& y,
							 const MayGoOn& mayGoOn) {
	const bool preconditioned = epsilon < plainAbove * greatestResponse_ && factorize(epsilon);
	const auto precondition = [&](const Eigen::VectorXd& r) {
		return preconditioned ? preconditioner(r, epsilon) : r;
	};
	Eigen::VectorXd residual = b - apply(y) - epsilon * y;
	Eigen::VectorXd z = precondition(residual), direction = z;
	double descent = residual.dot(z);
	const double enough = tolerance * b.norm();
	for (int step = 0; step < stepLimit && residual.norm() > enough; ++step) {
		if (!mayGoOn())
			return false;
		const Eigen::VectorXd image = apply(direction) + epsilon * direction;
		const double length = descent / direction.dot(image);
		y += length * direction;
		residual -= length * image;
		z = precondition(residual);
		const double newDescent = residual.dot(z);
		direction = z + (newDescent / descent) * direction;
		descent = newDescent;
	}
	return true;
}

bool MultiplierSolver::factorize(double epsilon) {
	return factorization_.factorize(jacobian_.massProduct(slackMass * epsilon));
}

Eigen::VectorXd MultiplierSolver::preconditioner(const Eigen::VectorXd& residual, double epsilon) const {
	const Eigen::VectorXd u = factorization_.solve(residual);
	const Positions lifted = jacobian_.applyTransposed(u) * inverseMass_.asDiagonal();
	const Eigen::VectorXd weighed = jacobian_.apply(metric_.apply(lifted) * inverseMass_.asDiagonal()) +
									epsilon * slackMass * slackMass * u;
	return factorization_.solve(weighed);
}

} // namespace developable::detail
