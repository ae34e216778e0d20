// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_cholesky.cpp: the two factorisations that SparseCholesky may stand for.
#include "sparse_cholesky.h"

#ifdef DEVELOPABLE_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#include <mutex>
#else
#include <Eigen/SparseCholesky>
#endif

namespace developable {

#ifdef DEVELOPABLE_WITH_CHOLMOD

/// On METIS' order of elimination.
class SparseCholesky::Factorization : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
public:
	Factorization() {
		cholmod().nmethods = 1;
		cholmod().method[0].ordering = CHOLMOD_METIS;
		cholmod().print = 0;
	}

	bool positiveDefinite() const { return info() == Eigen::Success; }

	/// METIS draws its random numbers from one row for the whole process, begun anew for each order: one
	/// order at a time, so that it is the same on every run.
	void findOrder(const SparseMatrix& matrix) {
		static std::mutex oneAtATime;
		const std::lock_guard lock(oneAtATime);
		analyzePattern(matrix);
	}

	/// Of the factor, once the pattern is known, bytes: its numbers, and half as many zeros between them.
	double factorMemory() { return 1.5 * 8 * cholmod().lnz; }
};

#else

class SparseCholesky::Factorization : public Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> {
public:
	/// It factorises many other matrices too; CHOLMOD refuses them.
	bool positiveDefinite() const { return info() == Eigen::Success && (vectorD().array() > 0).all(); }

	void findOrder(const SparseMatrix& matrix) { analyzePattern(matrix); }

	/// Of the factor, once the pattern is known, bytes.
	double factorMemory() const { return 12.0 * static_cast<double>(m_matrix.nonZeros()); }
};

#endif

SparseCholesky::SparseCholesky() : factorization_(std::make_unique<Factorization>()) {}
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

double SparseCholesky::analyze(const SparseMatrix& matrix) {
	factorization_->findOrder(matrix);
	analyzed_ = true;
	return factorization_->factorMemory();
}

bool SparseCholesky::factorize(const SparseMatrix& matrix) {
	if (!analyzed_)
		analyze(matrix);
	factorization_->factorize(matrix);
	return factorization_->positiveDefinite();
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& rightHandSide) const {
	return factorization_->solve(rightHandSide);
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& rightHandSides) const {
	return factorization_->solve(rightHandSides);
}

} // namespace developable
