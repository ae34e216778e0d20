// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_solver.cpp: the choice between factorisation and iteration, and Eigen's conjugate gradients.
#include "sparse_solver.h"

#include "memory.h"

#include <Eigen/IterativeLinearSolvers>

namespace developable {

namespace {

constexpr double memoryShare = 0.7; ///< of what the machine has, for the factor

} // namespace

class SparseSolver::Iterative {
public:
	explicit Iterative(const Iteration& iteration) {
		solver_.setTolerance(iteration.tolerance);
		solver_.setMaxIterations(iteration.stepLimit);
	}

	bool compute(const SparseMatrix& lower) {
		matrix_ = lower;
		solver_.compute(matrix_);
		return solver_.info() == Eigen::Success;
	}

	template <class RightHandSide>
	RightHandSide solve(const RightHandSide& rightHandSide) const {
		return solver_.solve(rightHandSide);
	}

private:
	using Preconditioner = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>;

	SparseMatrix matrix_;
	Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Preconditioner> solver_;
};

SparseSolver::SparseSolver(double memoryLimit, const Iteration& iteration)
	: memoryLimit_(memoryLimit), iteration_(iteration) {}

SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;
SparseSolver::~SparseSolver() = default;

bool SparseSolver::factorize(const SparseMatrix& lower) {
	if (!decided_) {
		const double limit = memoryLimit_ > 0 ? memoryLimit_ : memoryShare * availableMemory();
		decided_ = true;
		if (cholesky_.analyze(lower) > limit)
			iterative_ = std::make_unique<Iterative>(iteration_);
	}
	return iterative_ ? iterative_->compute(lower) : cholesky_.factorize(lower);
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& rightHandSide) const {
	return iterative_ ? iterative_->solve(rightHandSide) : cholesky_.solve(rightHandSide);
}

Eigen::MatrixXd SparseSolver::solve(const Eigen::MatrixXd& rightHandSides) const {
	return iterative_ ? iterative_->solve(rightHandSides) : cholesky_.solve(rightHandSides);
}

} // namespace developable
