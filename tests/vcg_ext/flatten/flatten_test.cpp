// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TriangleMesh noisySheet(double noise) {
	TriangleMesh mesh = jitteredGrid(25, 25, flatSheet);
	std::mt19937 random(3);
	for (auto& z : mesh.positions.row(2))
		z = noise * (2.0 * random() / std::mt19937::max() - 1);
	return mesh;
}

double doubleArea(const FlatPatterns& patterns, int triangle) {
	return detail::doubleArea(patterns.positions, patterns.triangles.col(triangle));
}

TEST(Flatten, DevelopablePanelsComeOutIsometric) {
	for (const TriangleMesh& mesh :
		 {jitteredGrid(15, 12, flatSheet), grid(20, 15, quarterCylinder), grid(15, 20, coneBand)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
		EXPECT_EQ(patterns.report.flippedFaces, 0);
		EXPECT_EQ(patterns.triangles, mesh.triangles); // a disk keeps its vertices' order
		EXPECT_TRUE(patterns.report.notes.empty());
	}
}

TEST(Flatten, StrainOfASphereCapIsThatOfItsCurvature) {
	// The strain of a flattened cap grows with its curvature times its area.
	const double strain = flattened(jitteredGrid(20, 20, sphereCap(1))).report.meanEdgeStrain;
	const double whole =
		1.05 / (8 * pi); // ∫K dA / 8π: the strain at the rim of a round cap of that curvature
	EXPECT_LT(strain, whole);
	EXPECT_GT(strain, whole / 10);
}

TEST(Flatten, FlipsNothingHoweverHardThePanel) {
	for (const TriangleMesh& mesh : {jitteredGrid(25, 25, bump(1, 30)), noisySheet(0.02), noisySheet(0.1)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_EQ(patterns.report.flippedFaces, 0);
		for (int t = 0; t < mesh.triangleCount(); ++t)
			EXPECT_GT(doubleArea(patterns, t), 0);
	}
}

TEST(Flatten, DoesNotDependOnWhereTheModelIsAndHowLargeItIs) {
	TriangleMesh mesh = jitteredGrid(18, 14, bumpedCylinder);
	const FlatPatterns before = flattened(mesh);
	const Positions positions = mesh.positions;
	for (const double scale : {1e-3, 1.0, 1e4}) {
		mesh.positions = moved(positions, scale, scale * Eigen::Vector3d(3, -2, 1));
		const FlatPatterns after = flattened(mesh);
		EXPECT_NEAR(after.report.maxEdgeStrain, before.report.maxEdgeStrain, 1e-8);
		EXPECT_NEAR(after.report.elasticEnergy / (scale * scale), before.report.elasticEnergy,
					1e-8 * before.report.elasticEnergy);
		EXPECT_LT((after.edgeStrain - before.edgeStrain).norm(), 1e-6);
	}
}

TEST(Flatten, IsTheSameEveryTime) {
	const TriangleMesh mesh = jitteredGrid(18, 14, bumpedCylinder);
	EXPECT_EQ(flattened(mesh).positions, flattened(mesh).positions);
}

TEST(Flatten, PiecesAreTheSameOnAnyNumberOfThreads) {
	const PatchAssembly assembly =
		assembled(together(together(jitteredGrid(18, 14, bumpedCylinder), grid(9, 12, coneBand)),
						   jitteredGrid(12, 12, sphereCap(1))));
	for (const double allowed : {0.0, 0.01}) {
		FlattenOptions options;
		options.bounds = StrainBounds::isotropic(allowed, allowed);
		options.threads = 1;
		const FlatPatterns single = flattenPatches(assembly, assembly.originalPositions, options);
		for (const int threads : {2, 3}) {
			options.threads = threads;
			EXPECT_EQ(flattenPatches(assembly, assembly.originalPositions, options).positions,
					  single.positions);
		}
	}
}

TEST(Flatten, TheOutsideShowsWhicheverWayTheFacesAreTurned) {
	TriangleMesh mesh = grid(12, 9, quarterCylinder);
	TriangleMesh inside = mesh;
	inside.triangles.row(1).swap(inside.triangles.row(2));
	for (int t = 0; t < mesh.triangleCount(); t += 3)
		mesh.triangles.col(t).reverseInPlace();
	const FlatPatterns front = flattened(grid(12, 9, quarterCylinder)), back = flattened(inside),
					   mixed = flattened(mesh);
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		EXPECT_GT(doubleArea(front, t), 0);
		EXPECT_GT(doubleArea(back, t), 0);
		EXPECT_EQ(doubleArea(mixed, t) > 0, t % 3 != 0) << "corners keep their order";
	}
	EXPECT_EQ(mixed.report.flippedFaces, 0);
	EXPECT_LT(mixed.report.maxEdgeStrain, 1e-12);
}

TEST(Flatten, RefusesWhatCannotBeFlatAndSaysHowMany) {
	try {
		flattened(together(octahedron(), grid(3, 3, flatSheet)));
		FAIL();
	} catch (const ClosedPatch& error) {
		EXPECT_NE(std::string(error.what()).find("1 of 2 patches"), std::string::npos) << error.what();
	}
	// A torus with a triangle missing has a boundary and a handle.
	TriangleMesh torus = ring(12, 9, [](double u, double v) -> Eigen::Vector3d {
		const double radius = 2 + std::cos(2 * pi * v);
		return {radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), std::sin(2 * pi * v)};
	});
	torus.triangles = torus.triangles.unaryExpr([](int v) { return v >= 96 ? v - 96 : v; }).eval();
	torus.triangles.conservativeResize(3, torus.triangles.cols() - 1);
	torus = makeMesh(torus.positions, torus.triangles);
	try {
		flattened(torus);
		FAIL();
	} catch (const PatchWithHandles& error) {
		EXPECT_NE(std::string(error.what()).find("1 patch has a handle"), std::string::npos) << error.what();
	}
	// A Möbius strip.
	TriangleMesh strip = grid(21, 3, [](double u, double v) -> Eigen::Vector3d {
		const double angle = 2 * pi * u, radius = 3 + (v - 0.5) * std::cos(angle / 2);
		return {radius * std::cos(angle), radius * std::sin(angle), (v - 0.5) * std::sin(angle / 2)};
	});
	const auto sewn = [](int v) { return v % 21 == 20 ? (2 - v / 21) * 21 : v; };
	EXPECT_THROW(flattened(makeMesh(strip.positions, strip.triangles.unaryExpr(sewn))), NonOrientablePatch);
	EXPECT_THROW(flattened(grid(3, 3, flatSheet), {std::nan(""), 400}), InvalidParameter);
	FlattenOptions options;
	options.threads = -1;
	EXPECT_THROW(flattened(grid(3, 3, flatSheet), options), InvalidParameter);
}

TEST(Flatten, StopsWhenAsked) {
	const PatchAssembly assembly = assembled(jitteredGrid(15, 15, sphereCap(1)));
	double furthest = 0;
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions, {},
												 [&](double fraction, const std::string& message) {
													 EXPECT_FALSE(message.empty());
													 EXPECT_GE(fraction, furthest);
													 EXPECT_LE(fraction, 1);
													 furthest = fraction;
													 return fraction < 0.002;
												 });
	EXPECT_TRUE(patterns.report.stopped);
	EXPECT_EQ(patterns.vertexCount(), 0);
}

} // namespace
} // namespace developable::test
