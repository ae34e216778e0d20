// SPDX-License-Identifier: GPL-3.0-or-later
// direct_system.h: systems in the multipliers by one factorisation in all three coordinates.
#pragma once

#include "bending_metric.h"
#include "defect_jacobian.h"
#include "developable/linear/linear.h"
#include "normal_system.h"

namespace developable::detail {

/// Of (J W⁻¹ Jᵀ + ε) y = b what a step takes, W⁻¹ Jᵀ y: it is the x of (JᵀJ + ε W) x = Jᵀ b (Woodbury
/// 1950), a sparse matrix with three unknowns a place. One factorisation costs as much as some tens of steps
/// of conjugate gradients, whatever ε and however stiff some triangles are.
class DirectSystem {
public:
	/// \param memoryLimit  see SparseSolver
	/// \param placeOrder   see NormalSystem
	explicit DirectSystem(double memoryLimit, std::vector<int> placeOrder = {})
		: system_(memoryLimit, std::move(placeOrder)) {}

	/// \param metric    W, its lower triangle
	/// \param response  3 x places; becomes W⁻¹ Jᵀ y
	/// \return          false when memory would not do, or rounding has spoilt the matrix
	bool solve(const SparseMatrix& metric, const DefectJacobian& jacobian, const Eigen::VectorXd& b,
			   double epsilon, Positions& response);

	/// The same with W, ε and J as they were in the last call but for rows of J that were foreseen since then
	/// (see DefectJacobian::foresee): few of them need no other factorisation.
	bool solveForeseen(const SparseMatrix& metric, const DefectJacobian& jacobian, const Eigen::VectorXd& b,
					   double epsilon, Positions& response);

	/// What a factorisation takes, see SparseCholesky; known after the first.
	double operations() const { return system_.operations(); }

	/// Whether the last solution took one.
	bool factorizedLast() const { return factorizedLast_; }

private:
	NormalSystem system_;
	bool factorized_ = false, factorizedLast_ = false;
	std::size_t rowsFactorized_ = 0; // of those that were foreseen
};

} // namespace developable::detail
