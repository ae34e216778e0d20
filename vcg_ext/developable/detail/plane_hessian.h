// SPDX-License-Identifier: GPL-3.0-or-later
// plane_hessian.h: a symmetric matrix with a 2 x 2 block for every vertex and every edge of a panel.
#pragma once

#include "sparse_cholesky.h"

#include <algorithm>
#include <array>
#include <vector>

namespace developable::detail {

/// Row and column 2 * vertex + axis; the lower triangle is stored. Its pattern is made once.
class PlaneHessian {
public:
	PlaneHessian(int vertexCount, const std::vector<std::array<int, 2>>& edges) : first_(vertexCount + 1, 0) {
		std::vector<std::array<int, 2>> below; // (column, row) of the blocks below the diagonal
		below.reserve(edges.size());
		for (const auto& [a, b] : edges)
			below.push_back({std::min(a, b), std::max(a, b)});
		std::sort(below.begin(), below.end());
		below.erase(std::unique(below.begin(), below.end()), below.end());
		for (const auto& [column, row] : below) {
			++first_[column + 1];
			rows_.push_back(row);
		}
		for (int vertex = 0; vertex < vertexCount; ++vertex)
			first_[vertex + 1] += first_[vertex];
		makePattern(vertexCount);
	}

	const SparseMatrix& matrix() const { return matrix_; }

	void setDiagonal(double value) {
		std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
		for (int column = 0; column < matrix_.cols(); ++column)
			matrix_.valuePtr()[matrix_.outerIndexPtr()[column]] = value;
	}

	/// Adds a block at the rows of one vertex and the columns of another, and its transpose across.
	void add(int row, int column, const Eigen::Matrix2d& block) {
		double* const values = matrix_.valuePtr();
		const int* const starts = matrix_.outerIndexPtr();
		if (row == column) {
			values[starts[2 * column]] += block(0, 0);
			values[starts[2 * column] + 1] += block(1, 0);
			values[starts[2 * column + 1]] += block(1, 1);
			return;
		}
		if (row < column)
			return add(column, row, block.transpose());
		const auto begin = rows_.begin() + first_[column];
		const int rank =
			static_cast<int>(std::lower_bound(begin, rows_.begin() + first_[column + 1], row) - begin);
		double* const left = values + starts[2 * column] + 2 + 2 * rank;
		double* const right = values + starts[2 * column + 1] + 1 + 2 * rank;
		left[0] += block(0, 0);
		left[1] += block(1, 0);
		right[0] += block(0, 1);
		right[1] += block(1, 1);
	}

private:
	void makePattern(int vertexCount) {
		matrix_.resize(2 * vertexCount, 2 * vertexCount);
		matrix_.resizeNonZeros(3 * vertexCount + 4 * static_cast<int>(rows_.size()));
		int next = 0;
		for (int column = 0; column < 2 * vertexCount; ++column) {
			matrix_.outerIndexPtr()[column] = next;
			for (int row = column; row <= (column | 1); ++row)
				matrix_.innerIndexPtr()[next++] = row;
			for (int i = first_[column / 2]; i < first_[column / 2 + 1]; ++i)
				for (const int axis : {0, 1})
					matrix_.innerIndexPtr()[next++] = 2 * rows_[i] + axis;
		}
		matrix_.outerIndexPtr()[2 * vertexCount] = next;
		setDiagonal(0);
	}

	std::vector<int> first_, rows_; // per vertex, the larger ones that it shares an edge with
	SparseMatrix matrix_;
};

} // namespace developable::detail
