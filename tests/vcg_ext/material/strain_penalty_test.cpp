// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/material/material.h"

#include "support/shapes.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// One triangle of a pattern, and it stretched by two factors along directions at an angle to the axes.
struct StretchedTriangle {
	Eigen::Matrix2Xd flat;
	Positions shaped;

	StretchedTriangle(double along, double across, double angle) : flat(2, 3) {
		flat << 0, 1.2, 0.3, 0, 0.1, 0.9;
		const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
		const Eigen::Matrix2d map = turn * Eigen::Vector2d(along, across).asDiagonal() * turn.transpose();
		Positions lifted = Positions::Zero(3, 3);
		lifted.topRows(2) = map * flat;
		shaped = moved(lifted, 1, Eigen::Vector3d(4, 5, 6));
	}

	StrainedTriangles triangles(double grain = 0) const {
		StrainedTriangles result;
		result.shaped = result.flat = Eigen::Vector3i(0, 1, 2);
		result.weights = Eigen::VectorXd::Ones(1);
		result.grain = {grain};
		return result;
	}
};

TEST(TriangleStrain, HasTheStretchesAndTheDirectionThatItWasMadeWith) {
	for (const double angle : {0.0, 0.4, 1.3, -0.7}) {
		const StretchedTriangle triangle(1.25, 0.9, angle);
		const TriangleStrain strain(triangle.shaped, triangle.flat);
		EXPECT_NEAR(strain.stretch(), 0.25, 1e-13);
		EXPECT_NEAR(strain.compression(), 0.1, 1e-13);
		const Eigen::Vector2d expected(std::cos(angle), std::sin(angle));
		EXPECT_NEAR(std::abs(strain.greatestDirection.dot(expected)), 1, 1e-12);
	}
}

TEST(StrainPenalty, ViolationsAreBeyondTheBoundsOfEachSign) {
	const StretchedTriangle triangle(1.05, 0.97, 0.4);
	const auto beyond = [&](double stretch, double compression) {
		return StrainPenalty(triangle.triangles(), StrainBounds::isotropic(stretch, compression), 0)
			.violations(triangle.shaped, triangle.flat)[0];
	};
	EXPECT_NEAR(beyond(0.04, 0.03), 0.01, 1e-12);
	EXPECT_NEAR(beyond(0.06, 0.01), 0.02, 1e-12);
	EXPECT_NEAR(beyond(0.05 + 1e-9, 0.03 + 1e-9), 0, 1e-12);
	EXPECT_NEAR(beyond(0, 0), 0.05, 1e-12);
}

TEST(StrainPenalty, GrainTurnsTheBounds) {
	const StretchedTriangle triangle(1.05, 1, 0.4);
	StrainBounds bounds = StrainBounds::isotropic(0.01, 0.01);
	bounds.directed = true;
	bounds.warp.stretch = 0.05 + 1e-9;
	bounds.bias.stretch = 0.03;
	const auto beyond = [&](double grain) {
		return StrainPenalty(triangle.triangles(grain), bounds, 0)
			.violations(triangle.shaped, triangle.flat)[0];
	};
	EXPECT_NEAR(beyond(0.4), 0, 1e-12);             // the warp bears it
	EXPECT_NEAR(beyond(0.4 + pi / 2), 0.04, 1e-12); // the weft does not
	EXPECT_NEAR(beyond(0.4 + pi / 4), 0.02, 1e-12); // the bias bears less
	EXPECT_NEAR(beyond(0.4 + pi), 0, 1e-12);
}

TEST(StrainPenalty, WhatIsAlikeForWarpWeftAndBiasIsBoundedBetweenThemToo) {
	const StretchedTriangle triangle(1.2, 0.97, pi / 8); // compressed half way between weft and bias
	StrainBounds bounds = StrainBounds::isotropic(0.25, 0);
	bounds.directed = true;
	const auto beyond = [&] {
		return StrainPenalty(triangle.triangles(0), bounds, 0).violations(triangle.shaped, triangle.flat)[0];
	};
	EXPECT_NEAR(beyond(), 0.03, 1e-12);
	bounds.warp.stretch = 0.3; // of one sign the bounds differ; the other's do not
	EXPECT_NEAR(beyond(), 0.03, 1e-12);
	bounds.warp.compression = 0.5; // along the others there is none
	EXPECT_NEAR(beyond(), 0, 1e-12);
}

TEST(StrainPenalty, GradientIsThatOfTheValue) {
	for (const int differing : {0, 1, 2}) { // signs whose bounds differ with the direction
		StretchedTriangle triangle(1.07, 0.94, 0.4);
		StrainBounds bounds = StrainBounds::isotropic(0.02, 0.03);
		bounds.directed = differing > 0;
		if (differing > 0)
			bounds.bias.stretch = 0.01;
		if (differing > 1)
			bounds.weft.compression = 0.01;
		StrainPenalty penalty(triangle.triangles(0.3), bounds, 1e-3);
		penalty.harden(10, 0.01);
		const auto gradient = penalty.element(0, triangle.shaped, triangle.flat).gradient;
		constexpr double step = 1e-6;
		for (int i = 0; i < 15; ++i) {
			double values[2];
			for (const int side : {0, 1}) {
				Positions shaped = triangle.shaped;
				Eigen::Matrix2Xd flat = triangle.flat;
				(i < 9 ? shaped.data()[i] : flat.data()[i - 9]) += side ? step : -step;
				values[side] = penalty.value(shaped, flat);
			}
			EXPECT_NEAR(gradient[i], (values[1] - values[0]) / (2 * step), 1e-7) << i << ' ' << differing;
		}
	}
}

TEST(StrainPenalty, HessianIsSemidefiniteAndKnowsRigidMotions) {
	const StretchedTriangle triangle(1.07, 0.94, 0.4);
	StrainPenalty penalty(triangle.triangles(), StrainBounds::isotropic(0.02, 0.03), 0);
	penalty.harden(10, 1e-4);
	const auto lower = penalty.element(0, triangle.shaped, triangle.flat).hessian;
	using Block = Eigen::Matrix<double, 15, 15>;
	const Block hessian = lower.selfadjointView<Eigen::Lower>();
	EXPECT_GT(Eigen::SelfAdjointEigenSolver<Block>(hessian).eigenvalues()[0], -1e-9);
	Eigen::Matrix<double, 15, 1> shift = Eigen::Matrix<double, 15, 1>::Zero();
	for (int corner = 0; corner < 3; ++corner)
		shift.segment<3>(3 * corner) = Eigen::Vector3d(1, 2, 3);
	EXPECT_LT((hessian * shift).norm(), 1e-9 * hessian.norm());
}

/// Of a stretched triangle nothing is left out but −p' times the square of the strain's derivative.
TEST(StrainPenalty, CurvatureOfStretchedShapesIsThatOfTheGradient) {
	for (const double across :
		 {1.05, 1.0699, 1.07}) { // principal directions turn the faster, the nearer both are
		const StretchedTriangle triangle(1.07, across, 0.4);
		StrainPenalty penalty(triangle.triangles(), StrainBounds::isotropic(0.02, 0.03), 0);
		penalty.harden(10, 1e-3);
		const auto along = [&](const Positions& direction, double length) {
			return direction.reshaped().dot(
				penalty.element(0, triangle.shaped + length * direction, triangle.flat).gradient.head<9>());
		};
		const Eigen::Matrix<double, 15, 15> hessian =
			penalty.element(0, triangle.shaped, triangle.flat).hessian.selfadjointView<Eigen::Lower>();
		std::mt19937 random(3);
		for (int i = 0; i < 20; ++i) {
			Positions direction(3, 3);
			for (double& coordinate : direction.reshaped())
				coordinate = 2.0 * random() / std::mt19937::max() - 1;
			constexpr double step = 1e-6;
			const double exact = (along(direction, step) - along(direction, -step)) / (2 * step);
			const double model =
				direction.reshaped().dot(hessian.topLeftCorner<9, 9>() * direction.reshaped());
			EXPECT_GT(model, 0.999 * exact) << across << ' ' << i;
			EXPECT_LT(model, 1.07 * exact) << across << ' ' << i;
		}
	}
}

TEST(StrainPenalty, IsInfiniteWhereThePatternIsFlipped) {
	const StretchedTriangle triangle(1, 1, 0);
	const StrainPenalty penalty(triangle.triangles(), StrainBounds::isotropic(0.1, 0.1), 0);
	Eigen::Matrix2Xd flipped = triangle.flat;
	flipped.row(0) *= -1;
	EXPECT_TRUE(std::isfinite(penalty.value(triangle.shaped, triangle.flat)));
	EXPECT_TRUE(std::isinf(penalty.value(triangle.shaped, flipped)));
}

TEST(RoundedPenalty, SlopesAreTheDerivativesOfItsValue) {
	const RoundedPenalty penalty = {3, 0.02};
	constexpr double step = 1e-6;
	for (const double c : {-1.0, -0.03, -1e-9, 0.0, 1e-3, 0.5}) {
		EXPECT_NEAR(penalty.first(c), (penalty.value(c + step) - penalty.value(c - step)) / (2 * step), 1e-8);
		EXPECT_NEAR(penalty.second(c), (penalty.first(c + step) - penalty.first(c - step)) / (2 * step),
					1e-7);
	}
	EXPECT_EQ(penalty.value(0), 0);
}

TEST(Hardening, HardensInProportionAndSharpensWithoutHardening) {
	StrainPenalty penalty(StrainedTriangles(), StrainBounds::isotropic(0.01, 0.01), 0);
	Hardening hardening(penalty);
	double stiffness = penalty.edge().stiffness, width = penalty.edge().width,
		   cost = hardening.costOfRounding();
	EXPECT_TRUE(hardening.harden());
	EXPECT_NEAR(penalty.edge().stiffness, 4 * stiffness, 1e-12);
	EXPECT_LT(penalty.edge().width, width);
	EXPECT_LT(hardening.costOfRounding(), cost);
	stiffness = penalty.edge().stiffness, width = penalty.edge().width, cost = hardening.costOfRounding();
	hardening.sharpen();
	EXPECT_EQ(penalty.edge().stiffness, stiffness);
	EXPECT_NEAR(penalty.edge().width, width / 2, 1e-15);
	EXPECT_NEAR(hardening.costOfRounding(), cost / 4, 1e-15);
	hardening.soften(); // to where it began
	EXPECT_NEAR(penalty.edge().width, 0.02, 1e-15);
	while (hardening.harden())
		EXPECT_LT(penalty.edge().stiffness, 1e9);
}

TEST(Grain, IsAChoiceOrADirectionOfAnyLength) {
	EXPECT_TRUE(Grain(Grain::LongestSeam).alongSeam());
	EXPECT_EQ(Grain(Grain::YAxis), Grain(Eigen::Vector3d(0, 1e-200, 0)));
	EXPECT_NEAR(Grain(Eigen::Vector3d(3, 0, -4e3)).direction().norm(), 1, 1e-15);
	EXPECT_THROW(Grain(Eigen::Vector3d::Zero()), InvalidParameter);
	EXPECT_THROW(Grain(Eigen::Vector3d(1, std::nan(""), 0)), InvalidParameter);
	EXPECT_THROW(Grain(Eigen::Vector3d(1.0 / 0.0, 0, 0)), InvalidParameter);
}

TEST(StrainBounds, BadOnesAreRefused) {
	for (const double bad : {-0.01, 11.0, std::nan(""), 1.0 / 0.0})
		EXPECT_THROW(requireValid(StrainBounds::isotropic(bad, 0)), InvalidParameter) << bad;
	for (const double bad : {-0.01, 1.0, std::nan("")})
		EXPECT_THROW(requireValid(StrainBounds::isotropic(0, bad)), InvalidParameter) << bad;
	EXPECT_NO_THROW(requireValid(StrainBounds::isotropic(0.5, 0.99)));
	EXPECT_FALSE(StrainBounds().any());
	EXPECT_TRUE(StrainBounds::isotropic(0, 0.01).any());
}

TEST(BendingRadius, IsThatOfACylinderAndScalesWithIt) {
	TriangleMesh mesh = jitteredGrid(31, 31, quarterCylinder);
	mesh.positions = moved(mesh.positions, 3, Eigen::Vector3d(1, 2, 3));
	const PatchAssembly assembly = assembled(mesh);
	const Eigen::VectorXd radii = bendingRadii(assembly, assembly.originalPositions);
	EXPECT_NEAR(radii.mean(), 3, 0.05);
	EXPECT_NEAR(shareBelowRadius(assembly, assembly.originalPositions, radii, 4), 1, 1e-12);
	EXPECT_EQ(shareBelowRadius(assembly, assembly.originalPositions, radii, 2), 0);
	EXPECT_NEAR(leastBendingRadius(2, 0.0012), 833.3, 0.1); // mild steel: some 400 thicknesses
	const PatchAssembly flat = assembled(grid(5, 5, flatSheet));
	EXPECT_NEAR(bendingRadii(flat, flat.originalPositions).minCoeff(), 10 * std::sqrt(2.0), 1e-9);
}

} // namespace
} // namespace developable::test
