// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_cholesky.h: one face for CHOLMOD's supernodal factorisation and Eigen's own.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace developable {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Cholesky factorisation of symmetric positive definite matrices of one pattern, of which only the lower
/// triangle is read: by CHOLMOD (Chen et al. 2008) where the library was built with it, else by Eigen. The
/// order of elimination is found once. All throw std::bad_alloc when there is too little memory.
class SparseCholesky {
public:
	SparseCholesky();
	SparseCholesky(SparseCholesky&&) noexcept;
	SparseCholesky& operator=(SparseCholesky&&) noexcept;
	~SparseCholesky();

	/// \param order  see eliminationOrder; empty: that of this matrix. Eigen's own always finds its own.
	/// \return       how much memory the factor will take, bytes
	double analyze(const SparseMatrix& matrix, const std::vector<int>& order = {});

	/// What a factorisation takes, in multiplications and additions, once the pattern is known.
	double operations() const { return operations_; }

	/// Says whether the matrix is positive definite; if not, there is nothing to solve with.
	bool factorize(const SparseMatrix& matrix);

	/// For one right-hand side, or for one in each column.
	Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide) const;
	Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const;

private:
	class Factorization;

	std::unique_ptr<Factorization> factorization_;
	bool analyzed_ = false;
	double operations_ = 0;
};

} // namespace developable
