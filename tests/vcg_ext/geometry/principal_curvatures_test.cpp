// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(PrincipalCurvatures, OfACylinderAreZeroAndOneOverItsRadius) {
	for (const double radius : {0.01, 1.0, 300.0}) {
		TriangleMesh mesh = jitteredGrid(31, 31, quarterCylinder);
		mesh.positions *= radius;
		const PatchAssembly assembly = assembled(mesh);
		const PrincipalCurvatures curvatures = principalCurvatures(assembly, mesh.positions);
		EXPECT_LT(curvatures.least.mean() * radius, 0.005);
		EXPECT_NEAR(curvatures.greatest.mean() * radius, 1, 0.005);
		EXPECT_LT((curvatures.greatest.array() * radius - 1).abs().maxCoeff(), 0.1); // at borders too
	}
}

TEST(PrincipalCurvatures, OfASphereAreOneOverItsRadius) {
	const TriangleMesh mesh = jitteredGrid(31, 31, sphereCap(2.5));
	const PrincipalCurvatures curvatures = principalCurvatures(assembled(mesh), mesh.positions);
	EXPECT_NEAR(curvatures.least.mean(), 0.4, 0.004);
	EXPECT_NEAR(curvatures.greatest.mean(), 0.4, 0.004);
}

TEST(PrincipalCurvatures, DoNotLookAcrossASeam) {
	// Two flat sheets at a right angle: every patch is flat, the object is not.
	const TriangleMesh upright = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(0, u, v); });
	const TriangleMesh mesh =
		together(grid(9, 9, [](double u, double v) { return Eigen::Vector3d(v, u, 0); }), upright);
	const PatchAssembly assembly = assembled(mesh);
	ASSERT_EQ(assembly.assemblingPlaceCount(), 9);
	EXPECT_LT(principalCurvatures(assembly, assembly.originalPositions).greatest.maxCoeff(), 1e-9);
}

TEST(PrincipalCurvatures, DoNotDependOnTheFacesOrientation) {
	TriangleMesh mesh = jitteredGrid(15, 15, bumpedCylinder);
	const PatchAssembly assembly = assembled(mesh);
	for (int t = 0; t < mesh.triangleCount(); t += 3)
		mesh.triangles.col(t).reverseInPlace();
	const PatchAssembly mixed = assembled(mesh);
	// Copies are numbered by their first corner, so they are compared place by place.
	const PrincipalCurvatures a = principalCurvatures(assembly, mesh.positions);
	const PrincipalCurvatures b = principalCurvatures(mixed, mesh.positions);
	Eigen::VectorXd atA(mesh.vertexCount()), atB(mesh.vertexCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		atA[assembly.placeOfCopy[copy]] = a.greatest[copy];
		atB[mixed.placeOfCopy[copy]] = b.greatest[copy];
	}
	// The fit's frame follows the order of neighbours, so it differs a little.
	EXPECT_LT((atA - atB).cwiseAbs().mean(), 5e-3);
	EXPECT_GT(atA.mean(), 0.5);
}

TEST(PrincipalCurvatures, OfASingleTriangleAreZero) {
	Positions positions(3, 3);
	positions << 0, 1, 0, 0, 0, 1, 0, 0, 0;
	const PatchAssembly assembly = assembled(makeMesh(positions, Eigen::Vector3i(0, 1, 2)));
	EXPECT_EQ(principalCurvatures(assembly, positions).greatest.maxCoeff(), 0);
}

} // namespace
} // namespace developable::test
