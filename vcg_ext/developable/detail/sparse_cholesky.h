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

#ifdef DEVELOPABLE_WITH_CHOLMOD

/// CHOLMOD (Chen et al. 2008) on METIS' order of elimination.
class CholeskyFactorization : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
public:
	CholeskyFactorization() {
		cholmod().nmethods = 1;
		cholmod().method[0].ordering = CHOLMOD_METIS;
		cholmod().print = 0;
	}

	bool positiveDefinite() const { return info() == Eigen::Success; }

	/// Of the factor, once the pattern is known, bytes: its numbers, and half as many zeros between them.
	double factorMemory() { return 1.5 * 8 * cholmod().lnz; }
};

#else

class CholeskyFactorization : public Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> {
public:
	/// It factorises many other matrices too; CHOLMOD refuses them.
	bool positiveDefinite() const { return info() == Eigen::Success && (vectorD().array() > 0).all(); }

	/// Of the factor, once the pattern is known, bytes.
	double factorMemory() const { return 12.0 * static_cast<double>(m_matrix.nonZeros()); }
};

#endif

/// The Cholesky factorisation of symmetric positive definite matrices of one pattern, of which only the lower
/// triangle is read. The order of elimination is found once.
class SparseCholesky {
public:
	/// Finds the order of elimination. \return how much memory the factor will take, bytes
	double analyze(const SparseMatrix& matrix) {
		factorization_.analyzePattern(matrix);
		analyzed_ = true;
		return factorization_.factorMemory();
	}

	/// Says whether the matrix is positive definite; if not, there is nothing to solve with.
	bool factorize(const SparseMatrix& matrix) {
		if (!analyzed_)
			analyze(matrix);
		factorization_.factorize(matrix);
		return factorization_.positiveDefinite();
	}

	template <class RightHandSide>
	typename RightHandSide::PlainObject solve(const RightHandSide& rightHandSide) const {
		return factorization_.solve(rightHandSide);
	}

private:
	CholeskyFactorization factorization_;
	bool analyzed_ = false;
};

} // namespace developable::detail
