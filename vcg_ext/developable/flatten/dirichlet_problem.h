// SPDX-License-Identifier: GPL-3.0-or-later
// dirichlet_problem.h: values inside a panel from values on its boundary.
#pragma once

#include "developable/linear/linear.h"

#include <vector>

namespace developable::detail {

/// A weighted graph Laplacian on a panel, solved inside for given values on the boundary.
class DirichletProblem {
public:
	/// \param weights  per half edge; an edge's weight is the sum over its half edges
	/// \param inner    per vertex, whether its value is sought
	DirichletProblem(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& weights,
					 const std::vector<char>& inner);

	bool solvable() const { return solvable_; }

	/// \param values   vertices x n; those on the boundary are read, those inside are written
	/// \param sources  vertices x n, what the Laplacian of the values is to be
	void solve(Eigen::MatrixXd& values, const Eigen::MatrixXd& sources) const;

private:
	std::vector<int> number_; // among the vertices inside, or -1
	int count_ = 0;
	Eigen::SparseMatrix<double> boundary_;
	SparseCholesky solver_;
	bool solvable_ = true;
};

} // namespace developable::detail
