// SPDX-License-Identifier: GPL-3.0-or-later
// conjugate_gradients.h: preconditioned conjugate gradients for operators that are no matrices.
#pragma once

#include <Eigen/Core>

namespace developable {

/// How a solution by conjugate gradients ended.
enum class Iterated {
	Enough,       ///< as exact as was asked for
	LimitOfSteps, ///< the solution is the best so far
	Indefinite, ///< the operator is not positive definite: the solution is what there was before that showed
	Stopped     ///< by the user
};

/// Solves A x = b for a symmetric positive definite operator A (Hestenes and Stiefel 1952), beginning at x.
/// Eigen's own can neither be stopped nor say that an operator is indefinite.
///
/// \param apply         the operator, from a vector to a vector
/// \param precondition  about its inverse, symmetric positive definite
/// \param enough        called with the residual r and rᵀP⁻¹r: whether that is exact enough
/// \param mayGoOn       called before each step; false asks for a stop
template <class Apply, class Precondition, class Enough, class MayGoOn>
Iterated conjugateGradients(const Apply& apply, const Precondition& precondition, const Eigen::VectorXd& b,
							int stepLimit, const Enough& enough, const MayGoOn& mayGoOn, Eigen::VectorXd& x) {
	Eigen::VectorXd residual = x.isZero(0) ? b : Eigen::VectorXd(b - apply(x));
	Eigen::VectorXd z = precondition(residual), direction = z;
	double product = residual.dot(z);
	for (int step = 0; !enough(residual, product); ++step) {
		if (step == stepLimit)
			return Iterated::LimitOfSteps;
		if (!mayGoOn())
			return Iterated::Stopped;
		const Eigen::VectorXd image = apply(direction);
		const double curvature = direction.dot(image);
		if (!(curvature > 0))
			return Iterated::Indefinite;
		const double length = product / curvature;
		x += length * direction;
		residual -= length * image;
		z = precondition(residual);
		const double before = product;
		product = residual.dot(z);
		direction = z + (product / before) * direction;
	}
	return Iterated::Enough;
}

} // namespace developable
