// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.h: the linear system of steps along given directions, put together in one pass.
#pragma once

#include "developable/linear/linear.h"

#include <vector>

namespace developable::detail {

/// Of A + ε NᵀWN the lower triangle, where A = (JN)ᵀ(JN): a row and a column for each direction in which a
/// place may go, one (its normal) or three (the coordinates). The pattern is found once; after that numbers
/// are written where they belong, without a sparse matrix in between.
class NormalSystem {
public:
	/// \param along       JN, rows x directions, always of the same pattern
	/// \param directions  N, 3 x directions; those of a place are neighbours, and at right angles to each
	///                    other
	/// \param metric      the lower triangle of W
	const SparseMatrix& fill(const SparseMatrix& along, const Eigen::Matrix3Xd& directions,
							 const SparseMatrix& metric, double epsilon);

private:
	using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

	void findPattern(const SparseMatrix& along, const SparseMatrix& metric);
	void addMetric(const Eigen::Matrix3Xd& directions, const SparseMatrix& metric, int column,
				   double epsilon);

	SparseMatrix lower_;
	Eigen::Index metricEntries_ = 0;  ///< that the pattern is for
	int perPlace_ = 1;                ///< directions
	std::vector<double*> entryOfRow_; ///< of the column at work
};

} // namespace developable::detail
