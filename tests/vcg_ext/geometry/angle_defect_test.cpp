// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// The definition, corner by corner with one arctangent each: slow and obvious.
Eigen::VectorXd defectsByDefinition(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd defects(assembly.copyCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		defects[copy] = assembly.copyInterior[copy] ? 2 * pi : 0;
	for (int corner = 0; corner < 3 * assembly.triangleCount(); ++corner) {
		const int copy = assembly.copyAt(corner);
		const Eigen::Vector3d at = positions.col(assembly.placeAt(corner));
		const Eigen::Vector3d a = positions.col(assembly.placeAt(nextCorner(corner))) - at;
		const Eigen::Vector3d b = positions.col(assembly.placeAt(previousCorner(corner))) - at;
		if (assembly.copyInterior[copy])
			defects[copy] -= std::atan2(a.cross(b).norm(), a.dot(b));
	}
	return defects;
}

TEST(AngleDefect, OfABorderIsWhatItsAnglesExceedAFullTurnBy) {
	// Half a ruff: its centre is on the border, where angles add up to 0.9 to 12 half turns.
	for (const double height : {0.0, 0.5, 2.0, 10.0}) {
		const int count = 13;
		Positions positions = Positions::Zero(3, count + 1);
		Eigen::Matrix3Xi triangles(3, count - 1);
		for (int i = 0; i < count; ++i) {
			const double angle = 0.9 * pi * i / (count - 1);
			positions.col(i + 1) << std::cos(angle), std::sin(angle), height * (i % 2 ? 1 : -1);
			if (i + 1 < count)
				triangles.col(i) << 0, i + 1, i + 2;
		}
		const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
		double sum = 0;
		for (const auto& places : assembly.trianglePlaces.colwise()) {
			const Eigen::Vector3d a = positions.col(places[1]), b = positions.col(places[2]);
			sum += std::atan2(a.cross(b).norm(), a.dot(b));
		}
		EXPECT_NEAR(borderAngles(assembly, positions)[assembly.triangleCopies(0, 0)], sum, 1e-12) << height;
		EXPECT_NEAR(flatDefects(assembly, positions).minCoeff(), std::min(0.0, 2 * pi - sum), 1e-12);
		EXPECT_EQ(flatDefects(assembly, positions).maxCoeff(), 0);
	}
}

TEST(AngleDefect, IsZeroOnCylinderConeAndPlane) {
	for (const Surface& surface : {Surface(flatSheet), Surface(quarterCylinder)}) {
		const PatchAssembly assembly = assembled(grid(12, 9, surface));
		EXPECT_LT(angleDefects(assembly, assembly.originalPositions).cwiseAbs().maxCoeff(), 1e-13);
	}
	// The rulings of a cone run along the grid, so its facets are planar quads, split either way.
	const PatchAssembly cone = assembled(grid(15, 7, coneBand));
	EXPECT_LT(angleDefects(cone, cone.originalPositions).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(AngleDefect, OfAnOctahedronIsAThirdOfAFullTurnAtEachVertex) {
	const PatchAssembly assembly = assembled(octahedron());
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	ASSERT_EQ(defects.size(), 6);
	for (const double defect : defects)
		EXPECT_NEAR(defect, 2 * pi / 3, 1e-14);
}

TEST(AngleDefect, AgreesWithItsDefinitionOverManyTurns) {
	// A ruff: the rim of the fan runs up and down, so that the angles at its centre add up to several turns.
	for (const double height : {0.0, 0.3, 1.0, 3.0, 10.0}) {
		const int count = 40;
		Positions positions = Positions::Zero(3, count + 1);
		Eigen::Matrix3Xi triangles(3, count);
		for (int i = 0; i < count; ++i) {
			const double angle = 2 * pi * i / count;
			positions.col(i + 1) << std::cos(angle), std::sin(angle), height * (i % 2 ? 1 : -1);
			triangles.col(i) << 0, i + 1, (i + 1) % count + 1;
		}
		const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
		const Eigen::VectorXd expected = defectsByDefinition(assembly, positions);
		EXPECT_LT((angleDefects(assembly, positions) - expected).cwiseAbs().maxCoeff(), 1e-12) << height;
		if (height == 10.0) {
			EXPECT_LT(expected.minCoeff(), -30 * pi); // the case is what it claims to be
		}
	}
}

TEST(AngleDefect, CurvatureOfASphereTendsToOneOverRadiusSquared) {
	const double radius = 2.5;
	double error = 1;
	for (int subdivisions = 2; subdivisions <= 5; ++subdivisions) {
		const PatchAssembly assembly = assembled(sphere(radius, subdivisions));
		const Eigen::VectorXd areas = copyAreas(assembly, assembly.originalPositions);
		const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
		const double mean = defects.sum() / areas.sum();
		const double newError = std::abs(mean * radius * radius - 1);
		EXPECT_LT(newError, 0.3 * error);
		error = newError;
	}
	EXPECT_LT(error, 2e-3);
}

TEST(AngleDefect, GaussianCurvatureOfARegularFanIsItsDefectOverItsArea) {
	const PatchAssembly assembly = assembled(octahedron());
	const Eigen::VectorXd curvatures = gaussianCurvatures(assembly, assembly.originalPositions);
	const double area = 4.0 / 3 * std::sqrt(3) / 2; // four triangles of side √2
	for (const double curvature : curvatures)
		EXPECT_NEAR(curvature, 2 * pi / 3 / area, 1e-13);
}

/// Gauss and Bonnet: angle defects inside and turning angles on the boundary add up to 2πχ.
TEST(AngleDefect, SatisfiesGaussAndBonnet) {
	for (const TriangleMesh& mesh : {octahedron(), sphere(3, 3), jitteredGrid(9, 12, bumpedCylinder),
									 jitteredGrid(10, 10, saddle), grid(6, 5, coneBand)}) {
		const PatchAssembly assembly = assembled(mesh);
		Eigen::VectorXd turning = Eigen::VectorXd::Constant(assembly.copyCount(), pi);
		for (int t = 0; t < assembly.triangleCount(); ++t) {
			const TriangleFrame frame = triangleFrame(mesh.positions, assembly.trianglePlaces.col(t));
			for (int corner = 0; corner < 3; ++corner)
				turning[assembly.triangleCopies(corner, t)] -= frame.angle(corner);
		}
		double sum = angleDefects(assembly, assembly.originalPositions).sum();
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			sum += assembly.copyInterior[copy] ? 0 : turning[copy];
		EXPECT_NEAR(sum, 2 * pi * assembly.patches[0].eulerCharacteristic(), 1e-11);
	}
}

TEST(AngleDefect, GradientOfTheDetectFunctionAgreesWithCentralDifferences) {
	TriangleMesh skewOctahedron = octahedron(); // the regular one is a minimum of G
	skewOctahedron.positions(0, 0) = 1.7;
	for (const TriangleMesh& mesh :
		 {jitteredGrid(7, 8, bumpedCylinder), jitteredGrid(8, 6, saddle), skewOctahedron}) {
		const PatchAssembly assembly = assembled(mesh);
		const auto function = [&](const Positions& positions) {
			return detectFunction(angleDefects(assembly, positions));
		};
		const Positions gradient =
			detectFunctionGradient(assembly, mesh.positions, angleDefects(assembly, mesh.positions));
		const Positions differences = centralDifferences(function, mesh.positions);
		EXPECT_LT((gradient - differences).norm(), 1e-6 * differences.norm());
	}
}

TEST(AngleDefect, GradientOfEveryCornerAngleAgreesWithCentralDifferences) {
	Positions triangle(3, 3);
	triangle << 0.1, 1.3, 0.4, -0.2, 0.3, 0.9, 0.5, 0.1, -0.3;
	const Eigen::Vector3i places(0, 1, 2);
	const AngleGradients gradients(triangleFrame(triangle, places));
	for (int corner = 0; corner < 3; ++corner) {
		const auto angle = [&](const Positions& p) { return triangleFrame(p, places).angle(corner); };
		const Positions differences = centralDifferences(angle, triangle);
		for (int vertex = 0; vertex < 3; ++vertex)
			EXPECT_LT((gradients.of(corner, vertex) - differences.col(vertex)).norm(), 1e-8);
	}
}

TEST(AngleDefect, GradientsOfLinkedCopiesAddUp) {
	// Two bumped sheets that share an edge of their grids, as vertices that coincide.
	const TriangleMesh left = jitteredGrid(6, 6, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 2 - right.positions.row(0).array(); // mirrored at x = 1
	const PatchAssembly assembly = assembled(together(left, right));
	ASSERT_EQ(assembly.assemblingPlaceCount(), 6);
	const auto function = [&](const Positions& positions) {
		return detectFunction(angleDefects(assembly, positions));
	};
	const Positions gradient = detectFunctionGradient(assembly, assembly.originalPositions,
													  angleDefects(assembly, assembly.originalPositions));
	const Positions differences = centralDifferences(function, assembly.originalPositions);
	EXPECT_LT((gradient - differences).norm(), 1e-6 * differences.norm());
}

TEST(AngleDefect, MeasuresDoNotChangeUnderRigidMotionAndScaling) {
	const TriangleMesh mesh = jitteredGrid(9, 9, bumpedCylinder);
	const PatchAssembly assembly = assembled(mesh);
	const Measures before = measure(assembly, mesh.positions, 0.01);
	EXPECT_GT(before.developability, 0.1);
	EXPECT_LT(before.developability, 0.9);
	for (const double scale : {1e-4, 1.0, 1e5}) {
		const Positions positions = moved(mesh.positions, scale, scale * Eigen::Vector3d(3, -2, 1));
		const Measures after = measure(assembly, positions, 0.01);
		EXPECT_NEAR(after.detectFunction, before.detectFunction, 1e-10);
		EXPECT_NEAR(after.developability, before.developability, 1e-10);
		EXPECT_NEAR(after.maxAngleDefect, before.maxAngleDefect, 1e-10);
		EXPECT_NEAR(after.totalAbsoluteCurvature, before.totalAbsoluteCurvature, 1e-9);
		const Eigen::VectorXd curvatures = gaussianCurvatures(assembly, positions);
		const Eigen::VectorXd expected = gaussianCurvatures(assembly, mesh.positions) / (scale * scale);
		EXPECT_LT((curvatures - expected).norm(), 1e-8 * expected.norm());
	}
}

TEST(AngleDefect, DevelopabilityIsTheShareOfAreaOfDevelopablePoints) {
	// A flat sheet of 5 x 5 with its middle vertex raised: its neighbours and itself lose their flatness.
	TriangleMesh mesh = grid(5, 5, flatSheet);
	mesh.positions(2, 12) = 0.1;
	const PatchAssembly assembly = assembled(mesh);
	const Eigen::VectorXd defects = angleDefects(assembly, mesh.positions);
	const Eigen::VectorXd areas = copyAreas(assembly, mesh.positions);
	double developable = 0;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		developable += std::abs(defects[copy]) <= 1e-4 ? areas[copy] : 0;
	EXPECT_NEAR(measure(assembly, mesh.positions, 1e-4).developability, developable / areas.sum(), 1e-14);
	EXPECT_LT(measure(assembly, mesh.positions, 1e-4).developability, 0.8);
	EXPECT_EQ(measure(assembly, mesh.positions, 4.0).developability, 1.0);
}

TEST(LargestAngleDefect, IsNotANumberWhereOneIsNot) {
	Eigen::VectorXd defects = Eigen::VectorXd::LinSpaced(9, -4, 3);
	EXPECT_EQ(largestAngleDefect(defects), 4);
	EXPECT_EQ(largestAngleDefect(Eigen::VectorXd()), 0);
	for (int i = 0; i < defects.size(); ++i) {
		Eigen::VectorXd spoilt = defects;
		spoilt[i] = std::nan("");
		EXPECT_TRUE(std::isnan(largestAngleDefect(spoilt))) << i;
	}
}

TEST(Measure, OfAShapeThatIsNoNumbersIsNotDevelopable) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 6, saddle));
	Positions positions = assembly.originalPositions;
	positions(0, 14) = std::nan("");
	const Measures measures = measure(assembly, positions, 1);
	EXPECT_TRUE(std::isnan(measures.maxAngleDefect));
	EXPECT_FALSE(measures.developability == 1);
}

} // namespace
} // namespace developable::test
