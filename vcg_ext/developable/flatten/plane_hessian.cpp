// SPDX-License-Identifier: GPL-3.0-or-later
// plane_hessian.cpp: where the entries of each block are among those of the matrix.
#include "plane_hessian.h"

#include "developable/mesh/mesh.h"

#include <algorithm>

namespace developable::detail {

PlaneHessian::PlaneHessian(int vertexCount, const std::vector<std::array<int, 2>>& edges) {
	std::vector<std::array<int, 2>> below; // (column, row) of the blocks below the diagonal
	below.reserve(edges.size());
	for (const auto& [a, b] : edges)
		below.push_back({std::min(a, b), std::max(a, b)});
	std::sort(below.begin(), below.end());
	below.erase(std::unique(below.begin(), below.end()), below.end());
	first_ = grouped(vertexCount, static_cast<int>(below.size()), [&](int i) { return below[i][0]; }).start;
	for (const auto& block : below)
		rows_.push_back(block[1]);
	makePattern(vertexCount);
}

void PlaneHessian::setDiagonal(double value) {
	std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
	for (int column = 0; column < matrix_.cols(); ++column)
		matrix_.valuePtr()[matrix_.outerIndexPtr()[column]] = value;
}

void PlaneHessian::addToDiagonal(double share) {
	const double added = share * matrix_.diagonal().maxCoeff();
	for (int column = 0; column < matrix_.cols(); ++column)
		matrix_.valuePtr()[matrix_.outerIndexPtr()[column]] += added;
}

void PlaneHessian::add(int row, int column, const Eigen::Matrix2d& block) {
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

void PlaneHessian::makePattern(int vertexCount) {
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

} // namespace developable::detail
