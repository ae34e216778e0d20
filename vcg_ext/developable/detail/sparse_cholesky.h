// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_cholesky.h: one face for CHOLMOD's supernodal factorisation and Eigen's own.
#pragma once

#include <Eigen/SparseCore>

#ifdef DEVELOPABLE_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace developable::detail {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Cholesky factorisation of symmetric positive definite matrices of one pattern, of which only the lower
/// triangle is read. The order of elimination is found once.
class SparseCholesky {
public:
	/// Says whether it succeeded. A matrix that is not positive definite fails with CHOLMOD, but need not
	/// with Eigen's factorisation, so callers that can't be sure of it check what they solve for.
	bool factorize(const SparseMatrix& matrix) {
		if (!analyzed_) {
#ifdef DEVELOPABLE_WITH_CHOLMOD
			factorization_.cholmod().nmethods = 1;
			factorization_.cholmod().method[0].ordering = CHOLMOD_METIS;
			factorization_.cholmod().print = 0;
#endif
			factorization_.analyzePattern(matrix);
			analyzed_ = true;
		}
		factorization_.factorize(matrix);
		return factorization_.info() == Eigen::Success;
	}

	template <class RightHandSide>
	typename RightHandSide::PlainObject solve(const RightHandSide& rightHandSide) const {
		return factorization_.solve(rightHandSide);
	}

private:
#ifdef DEVELOPABLE_WITH_CHOLMOD
	Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> factorization_;
#else
	Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factorization_;
#endif
	bool analyzed_ = false;
};

} // namespace developable::detail
