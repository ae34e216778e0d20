// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/bounded_strain/bending_bound.h"
#include "developable/bounded_strain/bounded_strain.h"

#include "spherical_cap.h"

#include <gtest/gtest.h>

#include <limits>

namespace developable::test {
namespace {

/// A sheet along x with a ridge of that least radius; it could be laid flat as it is.
TriangleMesh ridge(double leastRadius) {
	const double width = 0.15;
	return grid(25, 9, [=](double u, double v) {
		const double x = u - 0.5, height = width * width / leastRadius;
		return Eigen::Vector3d(u, v, height * std::exp(-x * x / (2 * width * width)));
	});
}

double shareBelow(const PatchAssembly& assembly, const Positions& positions, double radius) {
	return shareBelowRadius(assembly, positions, bendingRadii(assembly, positions), radius);
}

TEST(SecondDerivatives, OfThePositionsAreTheCurvature) {
	const PatchAssembly assembly = assembled(grid(17, 17, quarterCylinder));
	const Eigen::VectorXd greatest = principalCurvatures(assembly, assembly.originalPositions).greatest;
	const std::vector<SecondDerivatives> all = secondDerivatives(assembly, assembly.originalPositions);
	ASSERT_EQ(int(all.size()), assembly.copyCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const SecondDerivatives& at = all[copy];
		const Eigen::Matrix3d bent = assembly.originalPositions(Eigen::all, at.places) * at.rows.transpose();
		if (assembly.copyInterior[copy]) { // where the fitted plane is tangent
			EXPECT_NEAR(bent.norm(), greatest[copy], 0.03 * greatest[copy]);
		}
		EXPECT_LT((at.rows * Eigen::VectorXd::Ones(at.rows.cols())).norm(), 1e-9);
	}
}

TEST(BendingBound, DerivativesAreThoseOfItsValue) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, sphereCap(1)));
	for (const double radius : {0.3, 1.0}) {
		detail::BendingBound bound(assembly, {radius, 0.1});
		bound.harden(0.5);
		bound.take(assembly.originalPositions);
		const int size = 3 * assembly.placeCount();
		const auto gradientAt = [&](const Positions& shape, detail::BendingBound::Entries& entries) {
			Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
			bound.addDerivatives(shape, gradient, entries);
			return gradient;
		};
		detail::BendingBound::Entries entries, unused;
		const Eigen::VectorXd gradient = gradientAt(assembly.originalPositions, entries);
		SparseMatrix lower(size, size);
		lower.setFromTriplets(entries.begin(), entries.end());
		const Eigen::MatrixXd hessian = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
		constexpr double h = 1e-5;
		for (int i = 0; i < size; ++i) {
			Positions less = assembly.originalPositions, more = less;
			less.data()[i] -= h;
			more.data()[i] += h;
			EXPECT_NEAR(gradient[i], (bound.value(more) - bound.value(less)) / (2 * h), 1e-6) << i;
			const Eigen::VectorXd column = (gradientAt(more, unused) - gradientAt(less, unused)) / (2 * h);
			EXPECT_LT((hessian.col(i) - column).norm(), 1e-5 * (1 + column.norm())) << i;
		}
	}
}

TEST(BendingBound, ASheetIsUnbentToItsRadiusWithinItsStrain) {
	const PatchAssembly assembly = assembled(ridge(0.1));
	const StrainBounds bounds = StrainBounds::isotropic(0.002, 0.002);
	BoundedStrainOptions options;
	options.bounds = bounds;
	options.leastRadius = 0.2;
	ASSERT_GT(shareBelow(assembly, assembly.originalPositions, 0.2), 0.1);
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::Converged);
	EXPECT_EQ(shareBelow(assembly, positions, 0.2), 0);
	FlattenOptions flattening;
	flattening.bounds = bounds;
	EXPECT_LT(flattenPatches(assembly, positions, flattening).report.beyondBounds, patternTolerance);
	// It goes no farther than it has to.
	EXPECT_LT((positions - assembly.originalPositions).colwise().norm().maxCoeff(), 0.2);
}

TEST(BendingBound, WhatIsBentLessThanItBearsStays) {
	const PatchAssembly assembly = assembled(ridge(0.1));
	BoundedStrainOptions options;
	options.bounds = StrainBounds::isotropic(0.002, 0.002);
	options.leastRadius = 0.05;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::NothingToDo);
	EXPECT_TRUE(positions == assembly.originalPositions);
}

TEST(BendingBound, WhereItCantBeKeptStrainsAndTheLargestDisplacementAre) {
	const PatchAssembly assembly = assembled(ridge(0.1));
	BoundedStrainOptions options;
	options.bounds = StrainBounds::isotropic(0.002, 0.002);
	options.leastRadius = 0.4;
	options.maxDisplacement = 0.02;
	Positions positions = assembly.originalPositions;
	const BoundedStrainReport report = boundedStrain(assembly, positions, options);
	EXPECT_TRUE(converged(report.status));
	EXPECT_LE((positions - assembly.originalPositions).colwise().norm().maxCoeff(), 0.02);
	EXPECT_GT(shareBelow(assembly, positions, 0.4), 0);
	EXPECT_LE(shareBelow(assembly, positions, 0.4), shareBelow(assembly, assembly.originalPositions, 0.4));
	FlattenOptions flattening;
	flattening.bounds = options.bounds;
	EXPECT_LT(flattenPatches(assembly, positions, flattening).report.beyondBounds, patternTolerance);
}

TEST(BendingBound, BadRadiiAreRefused) {
	const PatchAssembly assembly = assembled(ridge(0.1));
	BoundedStrainOptions options;
	options.bounds = StrainBounds::isotropic(0.002, 0.002);
	for (const double radius :
		 {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
		options.leastRadius = radius;
		Positions positions = assembly.originalPositions;
		EXPECT_THROW(boundedStrain(assembly, positions, options), InvalidParameter);
		EXPECT_TRUE(positions == assembly.originalPositions);
	}
}

} // namespace
} // namespace developable::test
