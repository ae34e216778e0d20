// SPDX-License-Identifier: GPL-3.0-or-later
// plane_hessian.h: a symmetric matrix with a 2 x 2 block for every vertex and every edge of a panel.
#pragma once

#include "developable/linear/linear.h"

#include <array>
#include <vector>

namespace developable::detail {

/// Row and column 2 * vertex + axis; the lower triangle is stored. Its pattern is made once.
class PlaneHessian {
public:
	PlaneHessian(int vertexCount, const std::vector<std::array<int, 2>>& edges);

	const SparseMatrix& matrix() const { return matrix_; }

	/// Sets everything but the diagonal to 0.
	void setDiagonal(double value);

	/// Adds a share of the largest entry of the diagonal to all of it: what rounding may have taken from a
	/// matrix that has no negative eigenvalue.
	void addToDiagonal(double share);

	/// Adds a block at the rows of one vertex and the columns of another, and its transpose across.
	void add(int row, int column, const Eigen::Matrix2d& block);

private:
	void makePattern(int vertexCount);

	std::vector<int> first_, rows_; // per vertex, the larger ones that it shares an edge with
	SparseMatrix matrix_;
};

} // namespace developable::detail
