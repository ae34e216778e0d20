// SPDX-License-Identifier: GPL-3.0-or-later
// The angle about a slit's tip, and what it costs.
#include "developable/material/material.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

constexpr int spokes = 9; ///< of a fan round vertex 0, at distances that differ

Eigen::Matrix2Xd fan(double angle, double turn = 0) {
	Eigen::Matrix2Xd flat = Eigen::Matrix2Xd::Zero(2, spokes + 1);
	for (int i = 0; i < spokes; ++i) {
		const double at = turn + angle * i / (spokes - 1);
		flat.col(i + 1) = (1 + 0.1 * (i % 3)) * Eigen::Vector2d(std::cos(at), std::sin(at));
	}
	return flat;
}

BorderFans fansOf(const Eigen::Matrix2Xd& flat) {
	Eigen::Matrix3Xi triangles(3, spokes - 1);
	for (int t = 0; t < spokes - 1; ++t)
		triangles.col(t) << 0, t + 1, t + 2;
	return {triangles, Eigen::VectorXd::Constant(spokes - 1, 0.125), flat};
}

TEST(BorderFans, excessIsWhatIsBeyondAFullTurn) {
	for (const double turn : {0.0, 1.0, 2.5, 4.0})
		for (const double beyond : {-0.3, 0.0, 0.2, 1.0}) {
			const Eigen::Matrix2Xd flat = fan(2 * pi + beyond, turn);
			EXPECT_NEAR(fansOf(flat).excess(flat), std::max(beyond, 0.0), 1e-12);
		}
}

TEST(BorderFans, whatIsFarFromAFullTurnIsNotLookedAt) {
	const Eigen::Matrix2Xd flat = fan(pi);
	EXPECT_EQ(fansOf(flat).value({1, 0.1}, flat), 0);
	EXPECT_TRUE(fansOf(flat).elements({1, 0.1}, flat).empty());
}

TEST(BorderFans, gradientIsThatOfTheValueAndSecondDerivativesAreNoLess) {
	const RoundedPenalty edge{3, 0.05};
	const Eigen::Matrix2Xd flat = fan(2 * pi + 0.1, 0.7);
	const BorderFans fans = fansOf(flat);
	Eigen::VectorXd gradient = Eigen::VectorXd::Zero(flat.size());
	Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(flat.size(), flat.size());
	for (const BorderFans::EdgeElement& element : fans.elements(edge, flat))
		for (int i = 0; i < 4; ++i) {
			const int row = 2 * element.ends[i / 2] + i % 2;
			gradient[row] += element.gradient[i];
			for (int j = 0; j < 4; ++j)
				hessian(row, 2 * element.ends[j / 2] + j % 2) += element.hessian(i, j);
		}
	constexpr double h = 1e-6;
	Eigen::VectorXd difference(flat.size());
	for (Eigen::Index i = 0; i < flat.size(); ++i) {
		Eigen::Matrix2Xd more = flat, less = flat;
		more.data()[i] += h;
		less.data()[i] -= h;
		difference[i] = (fans.value(edge, more) - fans.value(edge, less)) / (2 * h);
	}
	EXPECT_LT((gradient - difference).norm(), 1e-7 * gradient.norm());
	EXPECT_GT(gradient.norm(), 0.1);
	// Along its own gradient the angle's square is what counts.
	EXPECT_GE(gradient.dot(hessian * gradient),
			  edge.second(0.1) / std::pow(edge.first(0.1), 2) * std::pow(gradient.squaredNorm(), 2));
}

} // namespace
} // namespace developable::test
