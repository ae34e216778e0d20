// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_solver.h: solves large systems by factorisation, or by iteration where memory would not do for that.
#pragma once

#include "sparse_cholesky.h"

namespace developable {

/// When an iteration ends.
struct Iteration {
	double tolerance = 1e-3; ///< on the residual, as a share of the right-hand side
	int stepLimit = 500;
};

/// Solves with symmetric positive definite matrices of one pattern. Before the first factorisation its memory
/// is estimated from the order of elimination; when there is not that much, conjugate gradients with an
/// incomplete factorisation serve instead, unless asked for otherwise exact enough for steps that the next
/// one corrects.
class SparseSolver {
public:
	/// \param memoryLimit  bytes that a factor may take; 0: what the machine has
	explicit SparseSolver(double memoryLimit = 0, const Iteration& iteration = {});
	SparseSolver(SparseSolver&&) noexcept;
	SparseSolver& operator=(SparseSolver&&) noexcept;
	~SparseSolver();

	/// For matrices of this pattern; else the first factorisation does that.
	/// \param order  see eliminationOrder; empty: that of this matrix
	void prepare(const SparseMatrix& lower, const std::vector<int>& order = {});
	bool prepared() const { return prepared_; }

	/// Of the matrix only the lower triangle is read. \return whether it succeeded
	bool factorize(const SparseMatrix& lower);

	/// For one right-hand side, or for one in each column.
	Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide) const;
	Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const;

	/// What a factorisation takes, see SparseCholesky.
	double operations() const { return cholesky_.operations(); }

	/// Whether memory would not do for a factorisation.
	bool iterates() const { return iterative_ != nullptr; }

private:
	class Iterative;

	double memoryLimit_;
	Iteration iteration_;
	bool prepared_ = false;
	SparseCholesky cholesky_;
	std::unique_ptr<Iterative> iterative_;
};

} // namespace developable
