// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/attempts.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

TEST(NewtonStrategy, ReachesADevelopableShapeNearSmoothOnes) {
	expectConverges(assembled(jitteredGrid(51, 51, sphereCap(1))), 0.015);
	expectConverges(assembled(jitteredGrid(51, 51, largeSaddle)), 0.055);
	expectConverges(assembled(jitteredGrid(51, 51, bumpedCylinder)), 0.006);
	expectConverges(assembled(jitteredGrid(51, 51, wave)), 0.011);
	expectConverges(assembled(jitteredGrid(51, 51, vamp)), 0.015);
	expectConverges(assembled(jitteredGrid(51, 51, steepBump)), 0.04);
}

TEST(NewtonStrategy, ReachesADevelopableShapeThroughNoiseHolesAndSeams) {
	expectConverges(assembled(noisy(jitteredGrid(51, 51, wave), 0.02)), 0.011);
	expectConverges(assembled(noisy(jitteredGrid(51, 51, largeSaddle), 0.02)), 0.06);
	expectConverges(assembled(withTwoHoles(51, bumpedCylinder)), 0.006);
	expectConverges(sewnPatches(41), 0.02);
}

TEST(NewtonStrategy, HardlyMovesWhatIsNearlyDevelopable) {
	for (const int columns : {21, 51}) {
		const PatchAssembly assembly = assembled(grid(columns, columns, bumpedCone(3e-4, 0.5)));
		ConstrainedNewtonOptions options;
		Positions near = assembly.originalPositions, far = near;
		const ConstrainedNewtonReport report = constrainedNewton(assembly, near, options);
		options.tuning.nearSteps = 0;
		const ConstrainedNewtonReport usual = constrainedNewton(assembly, far, options);
		ASSERT_EQ(report.status, Status::Converged);
		ASSERT_EQ(usual.status, Status::Converged);
		EXPECT_LE(report.iterations, usual.iterations);
		EXPECT_LT(meanDisplacement(assembly, near), meanDisplacement(assembly, far));
		EXPECT_LE(farthestMove(assembly, near),
				  options.tuning.nearMove * boxDiagonal(assembly.originalPositions));
	}
}

TEST(NewtonStrategy, MovesNoFartherThanWithoutLevels) {
	const PatchAssembly assembly = assembled(jitteredGrid(45, 45, bumpedCylinder));
	detail::NewtonProblem problem = problemOf(assembly);
	const detail::NewtonOutcome direct =
		detail::attemptFrom(problem, assembly.originalPositions, 3e-6, 200, {});
	ASSERT_EQ(direct.ending, detail::Ending::Reached);
	expectConverges(assembly, 1.1 * meanDisplacement(assembly, direct.positions));
}

/// What finer levels have to take away are short waves: long ones in their stead lead sewn panels far away.
TEST(NewtonStrategy, MovesSewnPanelsLessWithLessSmoothnessOnFinerLevels) {
	ConstrainedNewtonOptions usual, smoother;
	usual.tuning.otherLevels = smoother.tuning.otherLevels = 0;
	smoother.tuning.fineSmoothness = 1;
	const auto solved = [](const PatchAssembly& assembly, const ConstrainedNewtonOptions& options) {
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
		return positions;
	};
	for (const PatchAssembly& assembly : {mirroredPatches(40, vamp, 0.7), mirroredPatches(50, wave, 0.7)})
		EXPECT_LT(meanDisplacement(assembly, solved(assembly, usual)),
				  meanDisplacement(assembly, solved(assembly, smoother)));
	const PatchAssembly single = assembled(jitteredGrid(51, 51, bumpedCylinder));
	EXPECT_EQ(solved(single, usual), solved(single, smoother));
}

TEST(NewtonStrategy, DoesWithLittleMemory) {
	const PatchAssembly assembly = assembled(jitteredGrid(51, 51, bumpedCylinder));
	ConstrainedNewtonOptions options;
	options.memoryLimit = 1000;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
	const Positions withMuch = expectConverges(assembly, 0.006);
	EXPECT_NE(positions, withMuch); // so it did take another way
	EXPECT_LT((positions - withMuch).cwiseAbs().maxCoeff(), 0.005);
	expectSound(assembly, positions);
}

TEST(NewtonStrategy, GivesTheSameBitsOnEveryRunAndLeavesHeldPlaces) {
	TriangleMesh mesh = jitteredGrid(45, 45, bumpedCylinder);
	for (int vertex = 0; vertex < 45; ++vertex)
		mesh.vertexSelected[vertex] = 1;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, options);
	const Positions positions = expectConverges(assembly, 0.01);
	EXPECT_EQ(positions, expectConverges(assembly, 0.01));
	EXPECT_EQ(positions.leftCols(45), mesh.positions.leftCols(45));
}

TEST(NewtonStrategy, SaysThatAShapeWithAShortRimNeedsACut) {
	TriangleMesh mesh = sphere(1, 5);
	mesh.triangles = mesh.triangles.rightCols(mesh.triangleCount() - 64).eval();
	const PatchAssembly assembly = assembled(makeMesh(mesh.positions, mesh.triangles));
	ASSERT_GT(assembly.placeCount(), 3000);
	expectNeedsCut(assembly);
}

/// Levels of 1500, 2601 and 10404 places: half of the time is left when the finest begins, and a good deal of
/// it is gone while nothing was told, when the coarsest does.
TEST(NewtonStrategy, CountsCoarseningAndLevelsAsProgress) {
	const PatchAssembly assembly = assembled(jitteredGrid(102, 102, bumpedCylinder));
	Positions positions = assembly.originalPositions;
	double atCoarsest = 0, atFinest = 0;
	constrainedNewton(assembly, positions, {}, [&](double fraction, const std::string& message) {
		if (atCoarsest == 0 && message.rfind("1 steps", 0) == 0)
			atCoarsest = fraction;
		if (atFinest == 0 && message.rfind("10404 vertices", 0) == 0)
			atFinest = fraction;
		return true;
	});
	EXPECT_GT(atCoarsest, 0.05);
	EXPECT_LT(atCoarsest, 0.2);
	EXPECT_GT(atFinest, 0.4);
	EXPECT_LT(atFinest, 0.7);
}

TEST(NewtonStrategy, StopsOnAnyLevelAndLeavesThePositions) {
	const PatchAssembly assembly = assembled(jitteredGrid(45, 45, bumpedCylinder));
	Positions positions = assembly.originalPositions;
	int all = 0;
	double last = 0;
	const auto count = [&](double done, const std::string&) {
		EXPECT_GE(done, last);
		last = done;
		return ++all > 0;
	};
	Positions result = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, result, {}, count).status, Status::Converged);
	for (const int calls : {1, all / 2, all - 1}) {
		int left = calls;
		const auto stop = [&](double, const std::string&) { return --left > 0; };
		EXPECT_EQ(constrainedNewton(assembly, positions, {}, stop).status, Status::Stopped);
		EXPECT_EQ(positions, assembly.originalPositions);
	}
}

} // namespace
} // namespace developable::test
