// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/triangle_kernel.h"

#include "developable/geometry/fan_kernel.h"
#include "developable/geometry/geometry.h"
#include "kernel_results.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace developable::test {
namespace {

using namespace detail;

/// Units in the last place between two numbers.
double unitsApart(double a, double b) {
	const double unit = std::nextafter(std::abs(b), std::numeric_limits<double>::infinity()) - std::abs(b);
	return std::abs(a - b) / unit;
}

TEST(Argument, AgreesWithTheArctangentOfTheStandardLibraryAllRound) {
	for (int i = 0; i < 100000; ++i) {
		const double angle = (i / 50000.0 - 1) * pi * 0.99999;
		const double length = std::ldexp(1.0, i % 41 - 20);
		const double x = length * std::cos(angle), y = length * std::sin(angle);
		EXPECT_LE(unitsApart(argument(x, y), std::atan2(y, x)), 3) << x << " " << y;
	}
	for (double tangent = 1; tangent > 1e-300; tangent *= 0.37)
		for (const double sign : {1.0, -1.0})
			EXPECT_LE(unitsApart(argument(1.0, sign * tangent), std::atan(sign * tangent)), 2) << tangent;
	EXPECT_EQ(argument(-2.0, 0.0), pi);
	EXPECT_EQ(argument(0.0, -3.0), -pi / 2);
	EXPECT_TRUE(std::isnan(argument(0.0, 0.0)));
}

/// 0 on borders.
Eigen::VectorXd insideOnly(const PatchAssembly& assembly, Eigen::VectorXd values) {
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (!assembly.copyInterior[copy])
			values[copy] = 0;
	return values;
}

TEST(Kernels, GiveTheSameBitsForOneTwoAndFourNumbersAtATime) {
	// Fans of 3 to 9 corners, numbers of triangles and copies that no block divides, and a seam.
	for (const TriangleMesh& mesh :
		 {jitteredGrid(13, 17, bumpedCylinder), withTwoHoles(31, saddle), sphere(1, 2),
		  together(jitteredGrid(9, 9, saddle), jitteredGrid(8, 9, bumpedCylinder)), octahedron()}) {
		const PatchAssembly assembly = assembled(mesh);
		const KernelResults one = kernelResults<double>(assembly), two = kernelResults<TwoNumbers>(assembly),
							four = kernelResults<FourNumbers>(assembly);
		EXPECT_EQ(one.cotangents, two.cotangents);
		EXPECT_EQ(one.cotangents, four.cotangents);
		EXPECT_EQ(one.normals, two.normals);
		EXPECT_EQ(one.normals, four.normals);
		EXPECT_EQ(one.defects, two.defects);
		EXPECT_EQ(one.defects, four.defects);
		EXPECT_EQ(one.gradient, two.gradient);
		EXPECT_EQ(one.gradient, four.gradient);
		EXPECT_EQ(insideOnly(assembly, one.defects), angleDefects(assembly, assembly.originalPositions));
		EXPECT_EQ(-one.gradient, -weightedDefectGradient(assembly, assembly.originalPositions, one.defects));
	}
}

/// Fans of the same angles, more than a block of them.
std::vector<double> fanDefects(const std::vector<double>& cotangents) {
	constexpr int fans = 45;
	const int degree = static_cast<int>(cotangents.size());
	std::vector<double> all, defects(fans);
	std::vector<int> corners, start = {0};
	for (int fan = 0; fan < fans; ++fan) {
		for (const double cotangent : cotangents) {
			corners.push_back(static_cast<int>(all.size()));
			all.push_back(cotangent);
		}
		start.push_back(start.back() + degree);
	}
	runWide(FanKernel{all.data(), corners.data(), start.data(), fans, defects.data()});
	return defects;
}

TEST(Kernels, AddUpAnglesThatAreTooThinForProductsOfTheirCotangents) {
	// π/2 + π/2 + four angles of 1e-150 and, the product of their cotangents being no number, still π.
	for (const double defect : fanDefects({0, 1e150, 1e150, 1e150, 1e150, 0}))
		EXPECT_NEAR(defect, pi, 1e-15);
	for (const double defect : fanDefects({-1e150, -1e150, 1e150, 1e160}))
		EXPECT_NEAR(defect, 0, 1e-15);
}

TEST(Kernels, PassOnThatATriangleHasNoArea) {
	for (const double defect : fanDefects({0, std::numeric_limits<double>::quiet_NaN(), 0}))
		EXPECT_TRUE(std::isnan(defect));
}

TEST(Kernels, CountTurns) {
	for (int halves = 1; halves < 12; ++halves)
		for (const double cotangent : {0.0, -0.0})
			for (const double defect : fanDefects(std::vector<double>(halves, cotangent)))
				EXPECT_NEAR(defect, 2 * pi - halves * pi / 2, 1e-14);
}

} // namespace
} // namespace developable::test
