// SPDX-License-Identifier: GPL-3.0-or-later
// direct_system.cpp: the matrix, its solution, and what a few more rows change.
#include "direct_system.h"

#include <Eigen/Cholesky>

namespace developable::detail {

namespace {

/// Rows more than these cost as much as a factorisation.
constexpr std::size_t fewRows = 40;

} // namespace

bool DirectSystem::solve(const SparseMatrix& metric, const DefectJacobian& jacobian, const Eigen::VectorXd& b,
						 double epsilon, Positions& response) {
	const Eigen::Matrix3Xd coordinates = Eigen::Matrix3d::Identity().replicate(1, metric.cols());
	factorizedLast_ = true;
	rowsFactorized_ = jacobian.foreseenRows().size();
	factorized_ = system_.factorize(jacobian.matrix(), coordinates, metric, epsilon) && !system_.iterates();
	if (!factorized_)
		return false;
	const Eigen::VectorXd force = jacobian.applyTransposed(b).reshaped();
	response = system_.solve(force).reshaped(3, metric.cols());
	return response.allFinite();
}

/// With R the new rows and A the matrix without them, (A + RᵀR)⁻¹ f = A⁻¹f − A⁻¹Rᵀ (1 + R A⁻¹Rᵀ)⁻¹ R A⁻¹f.
bool DirectSystem::solveForeseen(const SparseMatrix& metric, const DefectJacobian& jacobian,
								 const Eigen::VectorXd& b, double epsilon, Positions& response) {
	const std::vector<int> rows = jacobian.foreseenRows();
	const std::size_t count = rows.size() - rowsFactorized_;
	if (!factorized_ || count > fewRows)
		return solve(metric, jacobian, b, epsilon, response);
	factorizedLast_ = false;
	const int newRows = static_cast<int>(count);
	Eigen::MatrixXd transposed(3 * metric.cols(), newRows + 1); // Rᵀ and f
	for (int i = 0; i < newRows; ++i)
		transposed.col(i) =
			jacobian.applyTransposed(Eigen::VectorXd::Unit(b.size(), rows[rowsFactorized_ + i])).reshaped();
	transposed.col(newRows) = jacobian.applyTransposed(b).reshaped();
	const Eigen::MatrixXd solved = system_.solve(transposed);
	const Eigen::MatrixXd products = transposed.leftCols(newRows).transpose() * solved;
	const Eigen::MatrixXd small = products.leftCols(newRows) + Eigen::MatrixXd::Identity(newRows, newRows);
	const Eigen::VectorXd x =
		solved.col(newRows) - solved.leftCols(newRows) * small.llt().solve(products.col(newRows));
	response = x.reshaped(3, metric.cols());
	return response.allFinite();
}

} // namespace developable::detail
