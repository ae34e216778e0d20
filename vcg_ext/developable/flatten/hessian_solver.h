// SPDX-License-Identifier: GPL-3.0-or-later
// hessian_solver.h: solves with the Hessians of one Newton step after the other.
#pragma once

#include "developable/linear/linear.h"

namespace developable::detail {

/// Solves H d = r for Hessians that change a little from one to the next: by conjugate gradients, with the
/// Cholesky factor of an earlier one as preconditioner, which is renewed when it no longer serves.
class HessianSolver {
public:
	/// \param matrix  of which the lower triangle is read
	/// \return        false when the matrix turned out not to be positive definite; the solution always goes
	///                down
	bool solve(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide, Eigen::VectorXd& solution);

private:
	Iterated solveWithOldFactor(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide,
								Eigen::VectorXd& solution) const;

	SparseCholesky factor_;
	bool factorized_ = false;
};

} // namespace developable::detail
