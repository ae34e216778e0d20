// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// Two triangles that share an edge and are folded along it by an angle.
TriangleMesh foldedPair(double angle) {
	Positions positions(3, 4);
	positions << 0, 1, 0.3, 0.6, 0, 0, 1, -std::cos(angle), 0, 0, 0, std::sin(angle);
	Eigen::Matrix3Xi triangles(3, 2);
	triangles << 0, 1, 1, 0, 2, 3;
	return makeMesh(positions, triangles);
}

double roughnessOf(const TriangleMesh& mesh) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	return roughness(assembly, assembly.originalPositions);
}

TEST(Roughness, IsTheFoldBetweenTwoFaces) {
	for (const double angle : {0.0, 0.1, 1.0, 2.0, 3.0})
		EXPECT_NEAR(roughnessOf(foldedPair(angle)), angle, 1e-12);
}

TEST(Roughness, IsTheRootMeanSquareOverAllEdges) {
	const TriangleMesh prism = grid(4, 2, [](double u, double v) -> Eigen::Vector3d {
		return {std::cos(u * pi), std::sin(u * pi), v};
	});
	// Three sides of a hexagon: two folds of pi/3, and three diagonals of flat quadrangles.
	EXPECT_NEAR(roughnessOf(prism), std::sqrt(2.0 / 5) * pi / 3, 1e-12);
}

TEST(Roughness, DoesNotDependOnTheOrientationOfFaces) {
	TriangleMesh mesh = jitteredGrid(9, 9, saddle);
	const double before = roughnessOf(mesh);
	for (int t = 0; t < mesh.triangleCount(); t += 3)
		std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
	EXPECT_GT(before, 0);
	EXPECT_NEAR(roughnessOf(mesh), before, 1e-15);
}

double meanAbsoluteCurvatureOf(const TriangleMesh& mesh) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	return meanAbsoluteCurvature(assembly, assembly.originalPositions);
}

/// Half of a cylinder of radius 1 and length 1 has 1/2 on an area of π, all of a unit sphere 1 on 4π, and the
/// middle of a shallow saddle as much as its principal curvatures, though its mean curvature is none.
TEST(MeanAbsoluteCurvature, IsThatOfASmoothShapeHoweverItIsMeshed) {
	const auto halfCylinder = [](int columns, int rows) {
		return grid(columns, rows, [](double u, double v) -> Eigen::Vector3d {
			return {std::cos(u * pi), std::sin(u * pi), v};
		});
	};
	EXPECT_NEAR(meanAbsoluteCurvatureOf(halfCylinder(101, 3)), pi / 2, 0.02 * pi / 2);
	EXPECT_NEAR(meanAbsoluteCurvatureOf(halfCylinder(201, 21)), pi / 2, 0.01 * pi / 2);
	EXPECT_NEAR(meanAbsoluteCurvatureOf(sphere(1, 4)), 4 * pi, 0.02 * 4 * pi);
	EXPECT_NEAR(meanAbsoluteCurvatureOf(sphere(3, 3)), 3 * 4 * pi, 0.03 * 3 * 4 * pi);
	const auto shallowSaddle = [](double u, double v) {
		return Eigen::Vector3d(u, v, 0.02 * (u * u - v * v));
	};
	EXPECT_NEAR(meanAbsoluteCurvatureOf(grid(41, 41, shallowSaddle)), 0.04, 0.03 * 0.04);
}

TEST(MeanAbsoluteCurvature, CountsFoldsOfBothSides) {
	for (const double angle : {0.0, 0.5, 2.0})
		EXPECT_NEAR(meanAbsoluteCurvatureOf(foldedPair(angle)), angle / 2, 1e-12);
	EXPECT_EQ(meanAbsoluteCurvatureOf(jitteredGrid(7, 7, flatSheet)), 0);
}

TEST(Roughness, IsZeroForOneFaceAndForAFlatSheet) {
	TriangleMesh triangle = foldedPair(1);
	triangle.triangles.conservativeResize(3, 1);
	triangle.triangleSelected.resize(1);
	triangle.face.resize(1);
	EXPECT_EQ(roughnessOf(triangle), 0);
	EXPECT_EQ(roughnessOf(jitteredGrid(7, 7, flatSheet)), 0);
}

} // namespace
} // namespace developable::test
