// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/plane_springs.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <random>

namespace developable::test {
namespace {

/// Both triangles of a matrix of which one is stored.
Eigen::MatrixXd dense(const detail::PlaneHessian& hessian) {
	const Eigen::MatrixXd lower(hessian.matrix());
	return lower.selfadjointView<Eigen::Lower>();
}

class Springs : public testing::TestWithParam<double> {};

/// With the barrier off and with it acting on most triangles.
TEST_P(Springs, DerivativesAgreeWithCentralDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 6, bump(0.5, 10)));
	const detail::PanelMesh panel = onlyPanel(assembly);
	detail::PlaneSprings springs(panel);
	springs.setGuardedShare(GetParam());
	const detail::PlanePositions x = panel.positions.topRows(2);
	const int size = static_cast<int>(x.size());
	const double step = 1e-6;
	const detail::PlanePositions gradient = springs.gradient(x);
	detail::PlaneHessian hessian = springs.hessianPattern(), convex = hessian;
	springs.addHessian(x, false, hessian);
	springs.addHessian(x, true, convex);
	const Eigen::MatrixXd full = dense(hessian);
	for (int i = 0; i < size; ++i) {
		detail::PlanePositions above = x, below = x;
		above.data()[i] += step;
		below.data()[i] -= step;
		const double slope = (springs.guardedEnergy(above) - springs.guardedEnergy(below)) / (2 * step);
		EXPECT_NEAR(gradient.data()[i], slope, 1e-7);
		const Eigen::VectorXd column =
			((springs.gradient(above) - springs.gradient(below)) / (2 * step)).reshaped();
		EXPECT_LT((full.col(i) - column).norm(), 1e-6 * full.col(i).norm());
	}
	const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense(convex)), eigenFull(full);
	EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-12);
	EXPECT_LT(eigenFull.eigenvalues().minCoeff(), -1e-3); // there was something to leave out
}

INSTANTIATE_TEST_SUITE_P(Barrier, Springs, testing::Values(0.1, 1.0, 3.0));

TEST(PlaneSprings, TheLongestStepIsWhereTheFirstTriangleLosesItsArea) {
	const PatchAssembly assembly = assembled(grid(4, 4, flatSheet));
	const detail::PanelMesh panel = onlyPanel(assembly);
	const detail::PlaneSprings springs(panel);
	const detail::PlanePositions x = panel.positions.topRows(2);
	std::mt19937 random(5);
	for (int round = 0; round < 20; ++round) {
		const detail::PlanePositions direction =
			x.unaryExpr([&](double) { return 2.0 * random() / std::mt19937::max() - 1; });
		const double longest = springs.longestStep(x, direction);
		ASSERT_TRUE(std::isfinite(longest));
		EXPECT_EQ(detail::countFlipped(panel.triangles, x + 0.9999 * longest * direction), 0);
		EXPECT_GT(detail::countFlipped(panel.triangles, x + 1.0001 * longest * direction), 0);
	}
	EXPECT_EQ(springs.longestStep(x, x), std::numeric_limits<double>::infinity()); // growing flips nothing
}

} // namespace
} // namespace developable::test
