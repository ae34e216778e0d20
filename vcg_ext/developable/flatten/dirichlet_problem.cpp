// SPDX-License-Identifier: GPL-3.0-or-later
// dirichlet_problem.cpp: the Laplacian between vertices inside, and from those on the boundary.
#include "dirichlet_problem.h"

#include "developable/mesh/mesh.h"

#include <utility>

namespace developable::detail {

DirichletProblem::DirichletProblem(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& weights,
								   const std::vector<char>& inner)
	: number_(inner.size(), -1) {
	for (std::size_t vertex = 0; vertex < inner.size(); ++vertex)
		if (inner[vertex])
			number_[vertex] = count_++;
	std::vector<Eigen::Triplet<double>> inside, across;
	inside.reserve(2 * weights.size());
	for (int h = 0; h < weights.size(); ++h)
		for (const auto& [a, b] : {std::pair(triangles.data()[h], triangles.data()[nextCorner(h)]),
								   std::pair(triangles.data()[nextCorner(h)], triangles.data()[h])}) {
			if (number_[a] < 0)
				continue;
			inside.emplace_back(number_[a], number_[a], weights[h]);
			if (number_[b] < 0)
				across.emplace_back(number_[a], b, weights[h]);
			else if (number_[b] < number_[a])
				inside.emplace_back(number_[a], number_[b], -weights[h]);
		}
	SparseMatrix matrix(count_, count_);
	matrix.setFromTriplets(inside.begin(), inside.end());
	boundary_.resize(count_, static_cast<int>(inner.size()));
	boundary_.setFromTriplets(across.begin(), across.end());
	solvable_ = count_ == 0 || solver_.factorize(matrix);
}

void DirichletProblem::solve(Eigen::MatrixXd& values, const Eigen::MatrixXd& sources) const {
	if (count_ == 0)
		return;
	Eigen::MatrixXd rightHandSide = boundary_ * values;
	for (std::size_t vertex = 0; vertex < number_.size(); ++vertex)
		if (number_[vertex] >= 0)
			rightHandSide.row(number_[vertex]) += sources.row(vertex);
	const Eigen::MatrixXd solution = solver_.solve(rightHandSide);
	for (std::size_t vertex = 0; vertex < number_.size(); ++vertex)
		if (number_[vertex] >= 0)
			values.row(vertex) = solution.row(number_[vertex]);
}

} // namespace developable::detail
