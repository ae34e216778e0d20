// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_solver.h: solves large systems by factorisation, or by iteration where memory would not do for that.
#pragma once

#include "memory.h"
#include "sparse_cholesky.h"

#include <Eigen/IterativeLinearSolvers>
#include <memory>

namespace developable::detail {

/// Solves with symmetric positive definite matrices of one pattern. Before the first factorisation its memory
/// is estimated from the order of elimination; when there is not that much, conjugate gradients with an
/// incomplete factorisation serve instead: exact enough for steps that are corrected by the next one.
class SparseSolver {
public:
	/// \param memoryLimit  bytes that a factor may take; 0: what the machine has
	explicit SparseSolver(double memoryLimit = 0) : memoryLimit_(memoryLimit) {}

	/// Of the matrix only the lower triangle is read. \return whether it succeeded
	bool factorize(const SparseMatrix& lower) {
		if (!iterative_ && !decided_) {
			const double limit = memoryLimit_ > 0 ? memoryLimit_ : memoryShare * availableMemory();
			decided_ = true;
			if (cholesky_.analyze(lower) > limit)
				iterative_ = std::make_unique<Iterative>();
		}
		if (!iterative_)
			return cholesky_.factorize(lower);
		matrix_ = lower;
		iterative_->setTolerance(tolerance);
		iterative_->setMaxIterations(stepLimit);
		iterative_->compute(matrix_);
		return iterative_->info() == Eigen::Success;
	}

	template <class RightHandSide>
	typename RightHandSide::PlainObject solve(const RightHandSide& rightHandSide) const {
		if (iterative_)
			return iterative_->solve(rightHandSide);
		return cholesky_.solve(rightHandSide);
	}

	/// Whether memory would not do for a factorisation.
	bool iterates() const { return iterative_ != nullptr; }

private:
	using Preconditioner = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>;
	using Iterative = Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Preconditioner>;
	static constexpr double memoryShare = 0.7; ///< of what the machine has, for the factor
	static constexpr double tolerance = 1e-3;  ///< on the residual, as a share of the right-hand side
	static constexpr int stepLimit = 500;

	double memoryLimit_;
	bool decided_ = false;
	SparseCholesky cholesky_;
	SparseMatrix matrix_;
	std::unique_ptr<Iterative> iterative_;
};

} // namespace developable::detail
