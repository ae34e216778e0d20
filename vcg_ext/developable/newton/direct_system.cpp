// SPDX-License-Identifier: GPL-3.0-or-later
// direct_system.cpp: the matrix and its solution.
#include "direct_system.h"

namespace developable::detail {

namespace {

/// The same matrix for each coordinate: of an entry i, j one at 3 i + k, 3 j + k for k = 0, 1, 2.
SparseMatrix forThreeCoordinates(const SparseMatrix& matrix) {
	std::vector<int> start(1, 0), rows;
	std::vector<double> values;
	rows.reserve(3 * matrix.nonZeros());
	values.reserve(3 * matrix.nonZeros());
	for (int column = 0; column < matrix.outerSize(); ++column)
		for (int coordinate = 0; coordinate < 3; ++coordinate) {
			for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
				rows.push_back(3 * static_cast<int>(entry.row()) + coordinate);
				values.push_back(entry.value());
			}
			start.push_back(static_cast<int>(rows.size()));
		}
	return Eigen::Map<const SparseMatrix>(3 * matrix.rows(), 3 * matrix.cols(),
										  static_cast<Eigen::Index>(values.size()), start.data(), rows.data(),
										  values.data());
}

} // namespace

bool DirectSystem::solve(const SparseMatrix& metric, const DefectJacobian& jacobian, const Eigen::VectorXd& b,
						 double epsilon, Positions& response) {
	const SparseMatrix derivative = jacobian.matrix();
	const SparseMatrix product = derivative.transpose() * derivative;
	const SparseMatrix system =
		SparseMatrix(product.triangularView<Eigen::Lower>()) / epsilon + forThreeCoordinates(metric);
	if (system.nonZeros() != nonZeros_) {
		solver_ = SparseSolver(memoryLimit_);
		nonZeros_ = system.nonZeros();
	}
	if (!solver_.factorize(system) || solver_.iterates())
		return false;
	const Eigen::VectorXd force = derivative.transpose() * (b / epsilon);
	response = solver_.solve(force).reshaped(3, metric.cols());
	return response.allFinite();
}

} // namespace developable::detail
