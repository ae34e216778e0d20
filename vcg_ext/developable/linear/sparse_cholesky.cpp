// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_cholesky.cpp: the two factorisations that SparseCholesky may stand for.
#include "sparse_cholesky.h"

#include "elimination_order.h"

#ifdef DEVELOPABLE_WITH_CHOLMOD
#include "developable/mesh/mesh.h"
#include "multifrontal.h"
#include "permuted_lower.h"

#include <Eigen/CholmodSupport>
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
		const cholmod_factor& factor = *m_cholmodFactor;
		const auto integers = [](const void* array) { return static_cast<const int*>(array); };
		multifrontal_ = std::make_unique<Multifrontal>(Supernodes{static_cast<int>(factor.nsuper),
																  integers(factor.super), integers(factor.pi),
																  integers(factor.px), integers(factor.s)});
		m_isInitialized = true;
		m_analysisIsOk = 1;
		m_factorizationIsOk = 0;
	}

	void findNumbers(const SparseMatrix& matrix) {
		forgetOutOfMemory();
		// As CHOLMOD's own routine has it: L Lᵀ, not L D Lᵀ.
		constexpr int withoutDiagonal = 1, supernodal = 1, packed = 1, monotonic = 1;
		if (m_cholmodFactor->xtype == CHOLMOD_PATTERN)
			cholmod_change_factor(CHOLMOD_REAL, withoutDiagonal, supernodal, packed, monotonic,
								  m_cholmodFactor, &cholmod());
		requireMemory();
		const bool found = matrix.isCompressed() && matrix.nonZeros() < largeMatrix
							   ? factorizePermuted(matrix)
							   : factorizeLarge(matrix);
		requireMemory();
		m_cholmodFactor->minor = found ? m_cholmodFactor->n : 0;
		m_info = found ? Eigen::Success : Eigen::NumericalIssue;
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

	/// CHOLMOD would permute the matrix twice, anew each time, which is up to a quarter of the work on a
	/// small one.
	bool factorizePermuted(const SparseMatrix& matrix) {
		permuted_.permute(matrix, static_cast<const int*>(m_cholmodFactor->Perm));
		return eliminate(permuted_.matrix());
	}

	bool factorizeLarge(const SparseMatrix& matrix) {
		constexpr int withNumbers = 1;
		const auto permuted = [this](cholmod_sparse* from, void* order) {
			const auto free = [this](cholmod_sparse* old) { cholmod_free_sparse(&old, &cholmod()); };
			std::unique_ptr<cholmod_sparse, decltype(free)> result(
				cholmod_ptranspose(from, withNumbers, static_cast<int*>(order), nullptr, 0, &cholmod()),
				free);
			requireMemory();
			return result;
		};
		cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
		const auto lower = permuted(permuted(&view, m_cholmodFactor->Perm).get(), nullptr); // first the upper
		const auto* const starts = static_cast<const int*>(lower->p);
		const Eigen::Index rows = matrix.rows();
		return eliminate({rows, rows, starts[rows], starts, static_cast<const int*>(lower->i),
						  static_cast<const double*>(lower->x)});
	}

	bool eliminate(const Eigen::Map<const SparseMatrix>& lower) {
		return multifrontal_->factorize(lower, threadsAtHand(), static_cast<double*>(m_cholmodFactor->x));
	}

	/// \throws std::bad_alloc  when CHOLMOD has had too little memory since it was forgotten
	void requireMemory() {
		if (m_cholmodFactor == nullptr || cholmod().status == CHOLMOD_TOO_LARGE || wasOutOfMemory() != 0)
			throw std::bad_alloc();
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
	std::unique_ptr<const Multifrontal> multifrontal_;
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
