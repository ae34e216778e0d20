// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"
#include "developable/flatten/held_grain.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace developable::test {
namespace {

/// Four triangles and their pattern, neither of them regular.
struct Fan {
	StrainedTriangles triangles;
	Positions shaped{3, 6};
	Eigen::Matrix2Xd flat{2, 6};

	Fan() {
		shaped << 0, 1, 1.1, 0.1, 2.2, 1.9, 0, 0.1, 1, 1.2, 0.3, 1.4, 0.2, 0.1, 0.6, 0.1, 0.9, 0.4;
		flat << 0.1, 1.1, 1.2, 0, 2.1, 2, 0, 0, 1.1, 1.3, 0.2, 1.5;
		triangles.flat.resize(3, 4);
		triangles.flat << 0, 0, 1, 2, 1, 2, 4, 4, 2, 3, 2, 5;
		triangles.shaped = triangles.flat;
		triangles.weights = Eigen::Vector4d(0.3, 0.2, 0.1, 0.4);
	}
};

struct WayToTell {
	Grain grain;
	std::array<int, 2> side;
};

const WayToTell everyWay[] = {{Grain::XAxis, {-1, -1}},     {Grain::YAxis, {-1, -1}},
							  {Grain::ZAxis, {-1, -1}},     {Grain(Eigen::Vector3d(0.3, -2, 1)), {-1, -1}},
							  {Grain::LongestSeam, {1, 5}}, {Grain::LongestSeam, {-1, -1}}};

double grainOf(const Fan& fan, const WayToTell& way) {
	return grainDirection(fan.triangles, fan.shaped, fan.flat, way.grain, way.side);
}

TEST(HeldGrain, SlopesAreTheDerivativesOfItsAngle) {
	constexpr double h = 1e-6;
	for (const WayToTell& way : everyWay) {
		const Fan fan;
		const HeldGrain held({{fan.triangles, way.side}}, way.grain, fan.shaped, fan.flat);
		const Eigen::VectorXd slopes = held.slopes(fan.shaped, fan.flat, true);
		const Eigen::VectorXd byPattern = held.slopes(fan.shaped, fan.flat, false);
		ASSERT_EQ(slopes.size(), 18 + 12);
		EXPECT_TRUE(byPattern == slopes.tail(12));
		for (int i = 0; i < slopes.size(); ++i) {
			double angles[2];
			for (const int side : {0, 1}) {
				Fan changed = fan;
				double& coordinate = i < 18 ? changed.shaped.data()[i] : changed.flat.data()[i - 18];
				coordinate += side == 0 ? -h : h;
				angles[side] = grainOf(changed, way);
			}
			EXPECT_NEAR(slopes[i], (angles[1] - angles[0]) / (2 * h), 1e-7)
				<< "coordinate " << i << ", grain " << way.grain.direction().transpose();
		}
	}
}

TEST(HeldGrain, AlignTurnsAPieceBackAndNothingElse) {
	for (const WayToTell& way : everyWay) {
		Fan fan;
		const HeldGrain held({{fan.triangles, way.side}}, way.grain, fan.shaped, fan.flat);
		const double before = grainOf(fan, way);
		fan.flat = Eigen::Rotation2Dd(1.2).toRotationMatrix() * fan.flat;
		fan.flat(0, 3) += 0.1;
		const Eigen::Matrix2Xd turned = fan.flat;
		held.align(fan.shaped, fan.flat);
		EXPECT_NEAR(std::remainder(grainOf(fan, way) - before, pi), 0, 1e-12);
		for (int i = 1; i < 6; ++i)
			EXPECT_NEAR((fan.flat.col(i) - fan.flat.col(0)).norm(), (turned.col(i) - turned.col(0)).norm(),
						1e-12);
	}
}

TEST(HeldGrain, WithoutAGrainNothingIsHeld) {
	Fan fan;
	const HeldGrain none;
	const Eigen::Matrix2Xd before = fan.flat;
	none.align(fan.shaped, fan.flat);
	EXPECT_TRUE(fan.flat == before);
	EXPECT_EQ(none.slopes(fan.shaped, fan.flat, true).cols(), 0);
}

TEST(HeldGrain, ADirectionIsTheBestOfThoseThatTurnNoPiece) {
	std::mt19937 random(7);
	std::normal_distribution<double> normal;
	const auto fill = [&](auto&& matrix) {
		for (double& value : matrix.reshaped())
			value = normal(random);
	};
	Eigen::MatrixXd root(6, 6), slopes(6, 2);
	Eigen::VectorXd gradient(6);
	fill(root);
	fill(slopes);
	fill(gradient);
	const Eigen::MatrixXd hessian = root * root.transpose() + Eigen::MatrixXd::Identity(6, 6);
	const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
	const Eigen::VectorXd direction = heldDirection(
		[&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return factor.solve(v); }, gradient, slopes);
	EXPECT_LT((slopes.transpose() * direction).norm(), 1e-12);
	const auto model = [&](const Eigen::VectorXd& p) { return gradient.dot(p) + p.dot(hessian * p) / 2; };
	const Eigen::MatrixXd allowed =
		Eigen::FullPivLU<Eigen::MatrixXd>(slopes.transpose()).kernel(); // directions that turn nothing
	for (Eigen::Index i = 0; i < allowed.cols(); ++i)
		for (const double step : {-1e-3, 1e-3})
			EXPECT_GT(model(direction + step * allowed.col(i)), model(direction));
}

} // namespace
} // namespace developable::test
