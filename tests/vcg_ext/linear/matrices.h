// SPDX-License-Identifier: GPL-3.0-or-later
// matrices.h: symmetric positive definite matrices that tests solve with.
#pragma once

#include "developable/linear/linear.h"

#include <tuple>
#include <vector>

namespace developable::test {

/// The lower triangle of the matrix of a square plate of side x side vertices that is held at each vertex a
/// little and resists being bent: holding I + bending L², L the Laplacian of the grid with free rims.
inline SparseMatrix plate(int side, double holding, double bending) {
	std::vector<Eigen::Triplet<double>> entries;
	const auto addEdge = [&](int a, int b) {
		for (const auto& [row, column, value] :
			 {std::tuple(a, a, 1.0), std::tuple(b, b, 1.0), std::tuple(a, b, -1.0), std::tuple(b, a, -1.0)})
			entries.emplace_back(row, column, value);
	};
	for (int i = 0; i < side; ++i)
		for (int j = 0; j + 1 < side; ++j) {
			addEdge(side * i + j, side * i + j + 1);
			addEdge(side * j + i, side * (j + 1) + i);
		}
	SparseMatrix laplacian(side * side, side * side), identity(side * side, side * side);
	laplacian.setFromTriplets(entries.begin(), entries.end());
	identity.setIdentity();
	const SparseMatrix bent = laplacian * laplacian;
	const SparseMatrix whole = holding * identity + bending * bent;
	return whole.triangularView<Eigen::Lower>();
}

/// One whose smallest and largest eigenvalues lie as far apart as those of the methods' systems do.
inline SparseMatrix plate(int side = 31) {
	return plate(side, 1.0 / (side * side), 1e-4 * side * side);
}

/// A smooth right-hand side and a rough one.
inline Eigen::MatrixXd loads(const SparseMatrix& lower) {
	Eigen::MatrixXd result(lower.rows(), 2);
	for (int row = 0; row < lower.rows(); ++row)
		result.row(row) << row / static_cast<double>(lower.rows()), row * row % 7 - 3;
	return result;
}

/// How much a solution leaves of a right-hand side.
inline double residualShare(const SparseMatrix& lower, const Eigen::VectorXd& solution,
							const Eigen::VectorXd& rightHandSide) {
	const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * solution;
	return (rightHandSide - image).norm() / rightHandSide.norm();
}

} // namespace developable::test
