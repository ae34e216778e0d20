// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_cholesky.cpp: the two factorisations that SparseCholesky may stand for.
#include "sparse_cholesky.h"

#include "elimination_order.h"

#ifdef DEVELOPABLE_WITH_CHOLMOD
#include "developable/mesh/mesh.h"
#include "permuted_lower.h"

#include <Eigen/CholmodSupport>
#include <dense_threads.h>
#include <new>
#include <out_of_memory.h>
#else
#include <Eigen/SparseCholesky>
#endif

namespace developable {

#ifdef DEVELOPABLE_WITH_CHOLMOD

class SparseCholesky::Factorization : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
public:
	Factorization() {
		cholmod().nmethods = 1;
		cholmod().method[0].ordering = CHOLMOD_GIVEN;
		cholmod().print = 0;
	}

	bool positiveDefinite() const { return info() == Eigen::Success; }

	void analyze(const SparseMatrix& matrix, const std::vector<int>& order) {
		permuted_ = {};
		forgetOutOfMemory();
		cholmod_free_factor(&m_cholmodFactor, &cholmod());
		cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
		// CHOLMOD only reads the order.
		m_cholmodFactor = cholmod_analyze_p(&view, const_cast<int*>(order.data()), nullptr, 0, &cholmod());
		requireMemory();
		m_isInitialized = true;
		m_analysisIsOk = 1;
		m_factorizationIsOk = 0;
	}

	void findNumbers(const SparseMatrix& matrix) {
		const DenseThreads threads(threadsAtHand());
		forgetOutOfMemory();
		if (matrix.isCompressed() && matrix.nonZeros() < largeMatrix)
			factorizePermuted(matrix);
		else
			factorize(matrix);
		requireMemory();
	}

	/// Of any number of columns. CHOLMOD finds all it works with allocated: it would not notice if the first
	/// of two pieces were missing.
	template <class RightHandSides>
	RightHandSides solution(const RightHandSides& rightHandSides) {
		const Eigen::Index rows = rightHandSides.rows(), columns = rightHandSides.cols();
		RightHandSides solved(rows, columns);
		Eigen::MatrixXd permuted(rows, columns);
		Eigen::MatrixXd gathered(columns, Eigen::Index(m_cholmodFactor->maxesize));
		cholmod_dense b = viewOf(rightHandSides), x = viewOf(solved), y = viewOf(permuted),
					  e = viewOf(gathered);
		cholmod_dense *toX = &x, *toY = &y, *toE = &e;
		forgetOutOfMemory();
		cholmod_solve2(CHOLMOD_A, m_cholmodFactor, &b, nullptr, &toX, nullptr, &toY, &toE, &cholmod());
		requireMemory();
		return solved;
	}

	/// Of the factor, once the pattern is known, bytes: its numbers, and half as many zeros between them.
	double factorMemory() { return 1.5 * 8 * cholmod().lnz; }

	/// Of a factorisation, multiplications and additions.
	double operations() { return cholmod().fl; }

private:
	static constexpr Eigen::Index largeMatrix = 2000000; ///< its places would take too much memory

	/// Hands the matrix over in the order of elimination. CHOLMOD would permute it twice, anew each time,
	/// which is up to a quarter of the work on a small one.
	void factorizePermuted(const SparseMatrix& matrix) {
		permuted_.permute(matrix, static_cast<const int*>(m_cholmodFactor->Perm));
		cholmod_sparse view = viewOf(permuted_.matrix());
		double noShift[] = {0, 0};
		cholmod_super_numeric(&view, nullptr, noShift, m_cholmodFactor, &cholmod());
		m_info = m_cholmodFactor->minor == m_cholmodFactor->n ? Eigen::Success : Eigen::NumericalIssue;
	}

	/// \throws std::bad_alloc  when CHOLMOD has had too little memory since it was forgotten
	void requireMemory() {
		if (m_cholmodFactor == nullptr || cholmod().status == CHOLMOD_TOO_LARGE || wasOutOfMemory() != 0)
			throw std::bad_alloc();
	}

	/// Of a lower triangle.
	static cholmod_sparse viewOf(const Eigen::Map<const SparseMatrix>& lower) {
		cholmod_sparse view = {};
		view.nrow = view.ncol = std::size_t(lower.cols());
		view.nzmax = std::size_t(lower.nonZeros());
		view.p = const_cast<int*>(lower.outerIndexPtr()); // CHOLMOD only reads
		view.i = const_cast<int*>(lower.innerIndexPtr());
		view.x = const_cast<double*>(lower.valuePtr());
		view.stype = -1;
		view.itype = CHOLMOD_INT;
		view.xtype = CHOLMOD_REAL;
		view.dtype = CHOLMOD_DOUBLE;
		view.packed = 1;
		return view;
	}

	template <class Numbers>
	static cholmod_dense viewOf(const Numbers& numbers) {
		cholmod_dense view = {};
		view.nrow = view.d = std::size_t(numbers.rows());
		view.ncol = std::size_t(numbers.cols());
		view.nzmax = std::size_t(numbers.size());
		view.x = const_cast<double*>(numbers.data()); // CHOLMOD only reads the right-hand sides
		view.xtype = CHOLMOD_REAL;
		view.dtype = CHOLMOD_DOUBLE;
		return view;
	}

	PermutedLower permuted_;
};

#else

class SparseCholesky::Factorization : public Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> {
public:
	/// It factorises many other matrices too; CHOLMOD refuses them.
	bool positiveDefinite() const { return info() == Eigen::Success && (vectorD().array() > 0).all(); }

	void analyze(const SparseMatrix& matrix, const std::vector<int>&) { analyzePattern(matrix); }
	void findNumbers(const SparseMatrix& matrix) { factorize(matrix); }

	template <class RightHandSides>
	RightHandSides solution(const RightHandSides& rightHandSides) const {
		return solve(rightHandSides);
	}

	/// Of the factor, once the pattern is known, bytes.
	double factorMemory() const { return 12.0 * static_cast<double>(m_matrix.nonZeros()); }

	/// Of a factorisation, multiplications and additions.
	double operations() const { return (m_nonZerosPerCol.cast<double>().array() + 1).square().sum(); }
};

#endif

SparseCholesky::SparseCholesky() : factorization_(std::make_unique<Factorization>()) {}
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

double SparseCholesky::analyze(const SparseMatrix& matrix, const std::vector<int>& order) {
	factorization_->analyze(matrix, order.empty() ? eliminationOrder(matrix) : order);
	analyzed_ = true;
	operations_ = factorization_->operations();
	return factorization_->factorMemory();
}

bool SparseCholesky::factorize(const SparseMatrix& matrix) {
	if (!analyzed_)
		analyze(matrix);
	factorization_->findNumbers(matrix);
	return factorization_->positiveDefinite();
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& rightHandSide) const {
	return factorization_->solution(rightHandSide);
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& rightHandSides) const {
	return factorization_->solution(rightHandSides);
}

} // namespace developable
