// SPDX-License-Identifier: GPL-3.0-or-later
// multiplier_solver.h: the linear systems of the constrained Newton method, in their multipliers.
#pragma once

#include "developable/linear/linear.h"
#include "direct_system.h"
#include "newton_problem.h"

#include <functional>

namespace developable::detail {

/// Solves (J W⁻¹ Jᵀ + ε) y = b by preconditioned conjugate gradients. W is factorised once and for all by the
/// metric and serves all three coordinates; a step costs one solve with it. The preconditioner is that of
/// Elman (1999, Preconditioning for the steady-state Navier-Stokes equations with low viscosity, "BFBt") for
/// the system with slack, [J √ε][W 0; 0 1]⁻¹[J √ε]ᵀ: with the masses M and 1/κ in place of W, P⁻¹ = K⁻¹ (J
/// M⁻¹ W M⁻¹ Jᵀ + ε κ²) K⁻¹, where K = J M⁻¹ Jᵀ + ε κ has one unknown a vertex and is factorised anew for
/// every J. It keeps the number of steps at some tens whatever ε and the tessellation.
class MultiplierSolver {
public:
	/// \param slow  products with the matrix in one system beyond which conjugate gradients count as slow
	MultiplierSolver(NewtonProblem& problem, int slow);

	/// J W⁻¹ Jᵀ y.
	Eigen::VectorXd apply(const Eigen::VectorXd& multipliers);

	/// About the largest eigenvalue of J W⁻¹ Jᵀ; `start` is a first guess at its eigenvector.
	double findGreatestResponse(Eigen::VectorXd start);

	/// W⁻¹ Jᵀ y of the solution. Once conjugate gradients have been slow, systems are factorised instead as
	/// far as that can be done (see DirectSystem); y is not touched then.
	/// \param y         the first guess; becomes the solution, or the best within the limit of steps
	/// \param mayGoOn   called once a step; returns false to ask for a stop
	/// \param response  3 x places
	/// \param foreseen  whether W, ε and J are as they were last time, but for rows that were foreseen since
	/// \return          false when asked to stop
	bool solve(const Eigen::VectorXd& b, double epsilon, Eigen::VectorXd& y,
			   const std::function<bool()>& mayGoOn, Positions& response, bool foreseen = false);

	/// Whether the last system was factorised: then others with the same W, ε and J cost little.
	bool factorizedLast() const { return factorized_; }

private:
	/// K.
	bool factorize(double epsilon);
	bool preconditionerIsDear() const;
	Iterated iterate(const Eigen::VectorXd& b, double epsilon, Eigen::VectorXd& y,
					 const std::function<bool()>& mayGoOn);
	Eigen::VectorXd preconditioned(const Eigen::VectorXd& residual, double epsilon) const;

	/// Whether that could be done.
	bool solveDirectly(const Eigen::VectorXd& b, double epsilon, bool foreseen, Positions& response);

	NewtonProblem& problem_;
	Eigen::VectorXd inverseMass_;
	SparseSolver factorization_; // of K
	DirectSystem direct_;
	const int slowProducts_;
	int products_ = 0; // in the last system
	bool slow_ = false, canFactorize_ = true, factorized_ = false;
	double greatestResponse_ = 0;
};

} // namespace developable::detail
