// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local/local_method.h"

#include "support/local_method_cases.h"
#include "support/slow_local_method.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(LocalMethod, NeverEndsWithALargerDetectFunction) {
	for (const int size : {6, 13, 21})
		for (const Surface& surface :
			 {Surface(bumpedCylinder), Surface(saddle), sphereCap(1.0), sphereCap(0.72)})
			for (const double displacement : {-1.0, 0.001, 0.1}) {
				const PatchAssembly assembly = assembled(jitteredGrid(size, size, surface));
				Positions positions = assembly.originalPositions;
				LocalMethodOptions options;
				options.maxDisplacement = displacement;
				options.maxOperations = 20000;
				localMethod(assembly, positions, options);
				EXPECT_LE(measured(assembly, positions).detectFunction,
						  measured(assembly, assembly.originalPositions).detectFunction);
			}
}

TEST(LocalMethod, MovesInnerVerticesAlongTheirNormalsWithinTheTolerance) {
	const PatchAssembly assembly = assembled(jitteredGrid(14, 14, bumpedCylinder));
	const Eigen::Matrix3Xd normals = copyNormals(assembly, assembly.originalPositions);
	LocalMethodOptions options;
	options.maxDisplacement = 0.004;
	Positions positions = assembly.originalPositions;
	localMethod(assembly, positions, options);
	double largest = 0;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int place = assembly.placeOfCopy[copy];
		const Eigen::Vector3d move = positions.col(place) - assembly.originalPositions.col(place);
		if (!assembly.copyInterior[copy]) {
			EXPECT_EQ(move.norm(), 0);
		}
		EXPECT_LT(move.cross(normals.col(copy)).norm(), 1e-15);
		EXPECT_LE(move.norm(), options.maxDisplacement * (1 + 1e-12));
		largest = std::max(largest, move.norm());
	}
	EXPECT_NEAR(largest, options.maxDisplacement, 1e-12); // the clamp was at work
}

TEST(LocalMethod, RepairsADentInASheet) {
	TriangleMesh mesh = grid(9, 9, flatSheet);
	mesh.positions(2, 40) = 0.02; // the middle
	const PatchAssembly assembly = assembled(mesh);
	Positions positions = assembly.originalPositions;
	LocalMethodOptions options;
	options.angleTolerance = 0.01;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Converged);
	EXPECT_EQ(report.reason, Reason::AsStatus);
	EXPECT_LE(measured(assembly, positions).maxAngleDefect, 0.01);
	EXPECT_GT(measured(assembly, assembly.originalPositions).maxAngleDefect, 0.01);
}

TEST(LocalMethod, FirstMoveIsThatOfEq19) {
	// One movable vertex: T = g², T' = 2 g g', so the first step is −g / (2 g').
	Positions positions(3, 5);
	positions << 0, 1, 0, -1, 0, 0, 0, 1, 0, -1, 0.3, 0, 0, 0, 0;
	Eigen::Matrix3Xi triangles(3, 4);
	triangles << 0, 0, 0, 0, 1, 2, 3, 4, 2, 3, 4, 1;
	const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
	const auto defectAt = [&](double height) {
		Positions at = positions;
		at(2, 0) = height;
		return angleDefects(assembly, at)[0];
	};
	const double slope = (defectAt(0.3 + 1e-6) - defectAt(0.3 - 1e-6)) / 2e-6;
	LocalMethodOptions options;
	options.maxOperations = 1;
	Positions result = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, result, options);
	EXPECT_EQ(report.iterations, 1);
	EXPECT_EQ(report.status, Status::LimitReached);
	EXPECT_NEAR(result(2, 0), 0.3 - defectAt(0.3) / (2 * slope), 1e-9);
}

TEST(LocalMethod, HoldsAssemblingVerticesAndImprovesThemThroughTheirNeighbours) {
	// A second sheet's corner is sewn to an inner vertex of the first: that place has a copy of its own in
	// each.
	TriangleMesh sheet = grid(11, 11, flatSheet);
	sheet.positions(2, 60) = 0.03;
	const TriangleMesh flap = grid(4, 4, [&](double u, double v) -> Eigen::Vector3d {
		return sheet.positions.col(60) + Eigen::Vector3d(u, v, 2 * (u + v));
	});
	const PatchAssembly assembly = assembled(together(sheet, flap));
	ASSERT_EQ(assembly.assemblingPlaceCount(), 1);
	Positions positions = assembly.originalPositions;
	localMethod(assembly, positions, {});
	EXPECT_EQ(positions.col(60), assembly.originalPositions.col(60));
	const double before = angleDefects(assembly, assembly.originalPositions)[60];
	EXPECT_GT(std::abs(before), 1e-3);
	EXPECT_LT(std::abs(angleDefects(assembly, positions)[60]), 0.5 * std::abs(before));
}

TEST(LocalMethod, EndsAtOnceWhenNothingMayMoveFar) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	Positions positions = assembly.originalPositions;
	LocalMethodOptions options;
	options.maxDisplacement = 0;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(report.reason, Reason::NothingMoves);
	const auto undevelopable =
		(angleDefects(assembly, positions).array().abs() > options.angleTolerance).count();
	EXPECT_GT(undevelopable, 20);
	EXPECT_EQ(report.setAside, undevelopable);
	EXPECT_EQ(report.iterations, undevelopable);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(LocalMethod, SaysWhenItHasFoundNothingBetterForLong) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions options;
	options.angleTolerance = 1e-9;
	Positions positions = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(report.reason, Reason::NotLowered);
	EXPECT_GT(report.iterations, 20 * 81);
	EXPECT_LT(report.iterations, options.maxOperations);
}

TEST(LocalMethod, GivesTheSameResultOnEveryRunAndForAnyScale) {
	const TriangleMesh mesh = jitteredGrid(12, 12, bumpedCylinder);
	const PatchAssembly assembly = assembled(mesh);
	LocalMethodOptions options;
	options.maxOperations = 300; // rounding grows with the number of operations
	Positions first = assembly.originalPositions, second = first;
	localMethod(assembly, first, options);
	localMethod(assembly, second, options);
	EXPECT_EQ(first, second);
	TriangleMesh larger = mesh;
	larger.positions *= 1024; // a power of two: scaling is exact
	const PatchAssembly assemblyOfLarger = assembled(larger);
	Positions third = assemblyOfLarger.originalPositions;
	localMethod(assemblyOfLarger, third, options);
	EXPECT_LT((third / 1024 - first).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LocalMethod, LeavesThePositionsAsTheyWereWhenStopped) {
	const PatchAssembly assembly = assembled(jitteredGrid(10, 10, saddle));
	Positions positions = assembly.originalPositions;
	const auto stop = [](double, const std::string&) { return false; };
	EXPECT_EQ(localMethod(assembly, positions, {}, stop).status, Status::Stopped);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(LocalMethod, RefusesWhatItCannotWorkOn) {
	const PatchAssembly closed = assembled(octahedron());
	Positions positions = closed.originalPositions;
	EXPECT_THROW(localMethod(closed, positions, {}), ClosedPatch);
	positions = jitteredGrid(5, 5, saddle).positions;
	PatchOptions allHeld;
	allHeld.fixSelected = true;
	TriangleMesh mesh = jitteredGrid(5, 5, saddle);
	mesh.vertexSelected.assign(25, 1);
	const PatchAssembly held = assembled(mesh, allHeld);
	EXPECT_THROW(localMethod(held, positions, {}), NothingFree);
}

void expectEqualToSlow(const PatchAssembly& assembly, double displacement, double tolerance) {
	Positions expected = assembly.originalPositions, positions = expected;
	const long operations = slowLocalMethod(assembly, expected, tolerance, displacement, 3000);
	LocalMethodOptions options;
	options.maxDisplacement = displacement;
	options.angleTolerance = tolerance;
	options.maxOperations = 3000;
	EXPECT_EQ(localMethod(assembly, positions, options).iterations, operations);
	EXPECT_EQ(positions, expected);
	EXPECT_NE(positions, assembly.originalPositions);
}

TEST(LocalMethod, EqualsTheSlowOneToTheLastBit) {
	int case_ = 0;
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(saddle), sphereCap(1.0)})
		for (const double displacement : {0.002, 0.05})
			for (const double tolerance : {0.01, 1e-4})
				expectEqualToSlow(assembled(jitteredGrid(8 + case_++ % 3, 9, surface)), displacement,
								  tolerance);
}

TEST(LocalMethod, EqualsTheSlowOneBetweenSeamsAndWhereVerticesAreEquallyBad) {
	expectEqualToSlow(sewnSheets(), 0.05, 1e-4);
	TriangleMesh mesh = grid(9, 9, flatSheet);
	for (const int vertex : {2 * 9 + 6, 4 * 9 + 4, 6 * 9 + 2}) // an order that no spatial one has
		mesh.positions(2, vertex) = 0.25;
	const PatchAssembly assembly = assembled(mesh);
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	ASSERT_EQ(defects[2 * 9 + 6], defects[6 * 9 + 2]);
	for (const double displacement : {0.01, 0.2})
		expectEqualToSlow(assembly, displacement, 1e-4);
}

} // namespace
} // namespace developable::test
