// SPDX-License-Identifier: GPL-3.0-or-later
// direct_system.h: systems in the multipliers by one factorisation in all three coordinates.
#pragma once

#include "bending_metric.h"
#include "defect_jacobian.h"
#include "developable/linear/linear.h"

namespace developable::detail {

/// Of (J W⁻¹ Jᵀ + ε) y = b what a step takes, W⁻¹ Jᵀ y: it is the x of (W + JᵀJ / ε) x = Jᵀ b / ε (Woodbury
/// 1950), a sparse matrix with three unknowns a place. One factorisation costs as much as some tens of steps
/// of conjugate gradients, whatever ε and however stiff some triangles are.
class DirectSystem {
public:
	/// \param memoryLimit  see SparseSolver
	explicit DirectSystem(double memoryLimit) : memoryLimit_(memoryLimit), solver_(memoryLimit) {}

	/// \param response  3 x places; becomes W⁻¹ Jᵀ y
	/// \return          false when memory would not do, or rounding has spoilt the matrix
	bool solve(const SparseMatrix& metric, const DefectJacobian& jacobian, const Eigen::VectorXd& b,
			   double epsilon, Positions& response);

private:
	double memoryLimit_;
	SparseSolver solver_;
	Eigen::Index nonZeros_ = 0; // of the pattern that the solver knows
};

} // namespace developable::detail
