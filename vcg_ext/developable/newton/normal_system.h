// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.h: the linear system of steps along given directions, put together in one pass, and
// factorised.
#pragma once

#include "developable/linear/linear.h"

#include <vector>

namespace developable::detail {

/// A + ε NᵀWN, where A = (JN)ᵀ(JN): a row and a column for each direction in which a place may go, one (its
/// normal) or three (the coordinates). The pattern is found once; after that
/// numbers are written where they belong, without a sparse matrix in between.
class NormalSystem {
public:
	/// \param memoryLimit  see SparseSolver
	/// \param placeOrder   see eliminationOrder: of a matrix with a row for each place; empty: found here
	explicit NormalSystem(double memoryLimit, std::vector<int> placeOrder = {})
		: memoryLimit_(memoryLimit), placeOrder_(std::move(placeOrder)), solver_(memoryLimit) {}

	/// Finds the pattern; else the first factorisation does.
	/// \param along   JN, rows x directions, always of the same pattern
	/// \param metric  the lower triangle of W
	void prepare(const SparseMatrix& along, const SparseMatrix& metric);

	/// The same without an order of elimination, for the pattern itself.
	void findPattern(const SparseMatrix& along, const SparseMatrix& metric);

	/// \param directions  N, 3 x directions; those of a place are neighbours, and at right angles to each
	///                    other
	/// \return            whether it succeeded
	bool factorize(const SparseMatrix& along, const Eigen::Matrix3Xd& directions, const SparseMatrix& metric,
				   double epsilon);

	/// With what was factorised last; for one right-hand side, or for one in each column.
	template <class RightHandSides>
	RightHandSides solve(const RightHandSides& rightHandSides) const {
		return solver_.solve(rightHandSides);
	}

	/// See SparseSolver.
	bool iterates() const { return solver_.iterates(); }

	/// What a factorisation takes, see SparseCholesky.
	double operations() const { return solver_.operations(); }

	/// Its lower triangle, as it was factorised last, or its pattern.
	const SparseMatrix& lower() const { return lower_; }

private:
	void fill(const SparseMatrix& along, const Eigen::Matrix3Xd& directions, const SparseMatrix& metric,
			  double epsilon);
	using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

	void addMetric(const Eigen::Matrix3Xd& directions, const SparseMatrix& metric, int column,
				   double epsilon);

	double memoryLimit_;
	std::vector<int> placeOrder_;
	SparseSolver solver_;
	SparseMatrix lower_;
	Eigen::Index metricEntries_ = 0;  ///< that the pattern is for
	int perPlace_ = 1;                ///< directions
	std::vector<double*> entryOfRow_; ///< of the column at work
};

} // namespace developable::detail
