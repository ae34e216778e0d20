// SPDX-License-Identifier: GPL-3.0-or-later
// sparse_solver.cpp: the choice between factorisation and iteration, and Eigen's conjugate gradients.
#include "sparse_solver.h"

#include "memory.h"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>

namespace developable {

namespace {

constexpr double memoryShare = 0.7; ///< of what the machine has, for the factor
/// Without rounding, as many steps as rows would do; what has not come to an end after ten times as many does
/// not.
constexpr Eigen::Index stepsPerRow = 10;

} // namespace

class SparseSolver::Iterative {
public:
	explicit Iterative(const Iteration& iteration) : stepLimit_(iteration.stepLimit) {
		solver_.setTolerance(iteration.tolerance);
	}

	bool compute(const SparseMatrix& lower) {
		matrix_ = lower;
		solver_.setMaxIterations(std::min<Eigen::Index>(stepLimit_, stepsPerRow * lower.rows()));
		solver_.compute(matrix_);
		return solver_.info() == Eigen::Success;
	}

	template <class RightHandSide>
	RightHandSide solve(const RightHandSide& rightHandSide) const {
		return solver_.solve(rightHandSide);
	}

private:
	using Preconditioner = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>;

	int stepLimit_;
	SparseMatrix matrix_;
	Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Preconditioner> solver_;
};

SparseSolver::SparseSolver(double memoryLimit, const Iteration& iteration)
	: memoryLimit_(memoryLimit), iteration_(iteration) {}

SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;
SparseSolver::~SparseSolver() = default;

void SparseSolver::prepare(const SparseMatrix& lower, const std::vector<int>& order) {
	const double limit = memoryLimit_ > 0 ? memoryLimit_ : memoryShare * availableMemory();
	prepared_ = true;
	if (cholesky_.analyze(lower, order) > limit)
		iterative_ = std::make_unique<Iterative>(iteration_);
}

bool SparseSolver::factorize(const SparseMatrix& lower) {
	if (!prepared_)
		prepare(lower);
	return iterative_ ? iterative_->compute(lower) : cholesky_.factorize(lower);
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& rightHandSide) const {
	return iterative_ ? iterative_->solve(rightHandSide) : cholesky_.solve(rightHandSide);
}

Eigen::MatrixXd SparseSolver::solve(const Eigen::MatrixXd& rightHandSides) const {
	return iterative_ ? iterative_->solve(rightHandSides) : cholesky_.solve(rightHandSides);
}

} // namespace developable
