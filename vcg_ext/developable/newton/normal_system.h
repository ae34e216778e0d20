// SPDX-License-Identifier: GPL-3.0-or-later
// normal_system.h: the linear system of steps along the normals, put together in one pass.
#pragma once

#include "developable/linear/linear.h"

#include <vector>

namespace developable::detail {

/// Of A + ε NᵀWN the lower triangle, where A = (JN)ᵀ(JN): one row and column a place. The pattern is found
/// once; after that numbers are written where they belong, without a sparse matrix in between.
class NormalSystem {
public:
	/// \param metric  the lower triangle of W, which has to outlive this
	explicit NormalSystem(const SparseMatrix& metric) : metric_(metric) {}

	/// \param along    JN, rows x places, always of the same pattern
	/// \param normals  N, 3 x places
	const SparseMatrix& fill(const SparseMatrix& along, const Eigen::Matrix3Xd& normals, double epsilon);

private:
	using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

	void findPattern(const SparseMatrix& along);

	const SparseMatrix& metric_;
	SparseMatrix lower_;
	std::vector<double*> entryOfRow_; ///< of the column at work
};

} // namespace developable::detail
