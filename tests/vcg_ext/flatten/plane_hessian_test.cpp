// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/plane_hessian.h"

#include "flat_shapes.h"

#include "developable/flatten/plane_springs.h"

#include <gtest/gtest.h>

#include <random>

namespace developable::test {
namespace {

/// A stiff element in every triangle, with one direction each: half of all directions stay soft.
detail::PlaneHessian stiffElements(const detail::PanelMesh& panel, double stiffness) {
	detail::PlaneHessian hessian = detail::PlaneSprings(panel).hessianPattern();
	hessian.setDiagonal(1e-9);
	std::mt19937 random(7);
	for (const auto& corners : panel.triangles.colwise()) {
		Eigen::Matrix<double, 6, 1> row;
		for (double& value : row)
			value = 2.0 * random() / std::mt19937::max() - 1;
		for (int i = 0; i < 3; ++i)
			for (int j = 0; j <= i; ++j)
				hessian.add(corners[i], corners[j],
							stiffness * row.segment<2>(2 * i) * row.segment<2>(2 * j).transpose());
	}
	return hessian;
}

TEST(PlaneHessian, WhatRoundingTakesFromSoftDirectionsIsGivenBack) {
	const detail::PanelMesh panel = onlyPanel(assembled(jitteredGrid(9, 9, bump(0.2, 8))));
	detail::PlaneHessian hessian = stiffElements(panel, 1e9);
	EXPECT_FALSE(SparseCholesky().factorize(hessian.matrix()));
	hessian.addToDiagonal(1e-13);
	EXPECT_TRUE(SparseCholesky().factorize(hessian.matrix()));
}

TEST(PlaneHessian, OnlyTheDiagonalIsAddedTo) {
	const detail::PanelMesh panel = onlyPanel(assembled(grid(4, 5, bump(0.2, 8))));
	detail::PlaneHessian hessian = stiffElements(panel, 2);
	const Eigen::MatrixXd before(hessian.matrix());
	hessian.addToDiagonal(0.25);
	const Eigen::MatrixXd added = Eigen::MatrixXd(hessian.matrix()) - before;
	const double expected = 0.25 * before.diagonal().maxCoeff();
	EXPECT_LT((added - expected * Eigen::MatrixXd::Identity(before.rows(), before.cols())).norm(), 1e-12);
}

} // namespace
} // namespace developable::test
