// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_metric.h"
#include "developable/newton/defect_jacobian.h"

#include "support/newton_checks.h"

namespace developable::test {
namespace {

/// A grid of which only the vertices within so many rows of the middle may move.
PatchAssembly heldOutside(int rows) {
	TriangleMesh mesh = jitteredGrid(15, 15, bumpedCylinder);
	for (int row = 0; row < 15; ++row)
		for (int column = 0; column < 15; ++column)
			mesh.vertexSelected[15 * row + column] = std::max(std::abs(row - 7), std::abs(column - 7)) > rows;
	PatchOptions options;
	options.fixSelected = true;
	return assembled(mesh, options);
}

TEST(ConstrainedNewton, ReachesADevelopableShapeNearSmoothOnes) {
	expectConverges(assembled(jitteredGrid(31, 31, sphereCap(1))), 0.015);
	expectConverges(assembled(jitteredGrid(31, 31, largeSaddle)), 0.045);
	expectConverges(assembled(jitteredGrid(31, 31, bumpedCylinder)), 0.006);
	expectConverges(assembled(jitteredGrid(31, 31, wave)), 0.007);
	expectConverges(assembled(jitteredGrid(31, 31, vamp)), 0.015);
}

TEST(ConstrainedNewton, ReachesADevelopableShapeFromASteepBump) {
	expectConverges(assembled(jitteredGrid(31, 31, steepBump)), 0.04);
}

TEST(ConstrainedNewton, ReachesADevelopableShapeAroundHoles) {
	const PatchAssembly assembly = assembled(withTwoHoles(31, bumpedCylinder));
	ASSERT_EQ(assembly.patches[0].eulerCharacteristic(), -1);
	expectConverges(assembly, 0.005);
}

TEST(ConstrainedNewton, ReachesADevelopableShapeThroughNoise) {
	expectConverges(assembled(noisy(jitteredGrid(31, 31, bumpedCylinder), 0.02)), 0.006);
	expectConverges(assembled(noisy(jitteredGrid(31, 31, wave), 0.02)), 0.007);
}

TEST(ConstrainedNewton, ReachesADevelopableShapeWithThinTriangles) {
	expectConverges(assembled(jitteredGrid(11, 91, bumpedCylinder, 0.2)), 0.008);
	// The angles of one degree and less come with much curvature of their own.
	expectConverges(assembled(jitteredGrid(11, 181, vamp, 0.2)), 0.017);
	expectConverges(assembled(jitteredGrid(11, 241, bumpedCylinder, 0.2)), 0.04);
}

/// A saddle one vertex of which is so near to the middle of the edge opposite.
TriangleMesh saddleWithAThinTriangle(double height) {
	TriangleMesh mesh = jitteredGrid(9, 9, saddle);
	Eigen::Vector3i thin = mesh.triangles.col(mesh.triangleCount() / 2);
	auto vertex = mesh.positions.col(thin[0]);
	vertex = height * vertex + (1 - height) / 2 * (mesh.positions.col(thin[1]) + mesh.positions.col(thin[2]));
	return mesh;
}

TEST(ConstrainedNewton, EndsWithTheBestShapeWhereASystemHasNoSolution) {
	// Triangles that are thin, but none so thin that it would be refused, and one that is.
	for (const double height : {1e-10, 1e-11, 1e-12}) {
		const PatchAssembly assembly = assembled(saddleWithAThinTriangle(height));
		Positions positions = assembly.originalPositions;
		const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
		EXPECT_EQ(report.status, Status::Stalled);
		EXPECT_EQ(report.reason, Reason::Unsolvable);
		EXPECT_LE(flatDefects(assembly, positions).squaredNorm(),
				  flatDefects(assembly, assembly.originalPositions).squaredNorm());
	}
	EXPECT_THROW(assembled(saddleWithAThinTriangle(1e-13)), DegenerateTriangle);
}

TEST(ConstrainedNewton, KeepsSeamsClosedAndConvergesInEveryPatch) {
	const TriangleMesh left = jitteredGrid(16, 16, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 2 - right.positions.row(0).array(); // mirrored at x = 1
	const PatchAssembly assembly = assembled(together(left, right));
	ASSERT_EQ(assembly.patchCount(), 2);
	ASSERT_EQ(assembly.assemblingPlaceCount(), 16); // one place, one position: a seam cannot open
	expectConverges(assembly, 0.02);
}

TEST(ConstrainedNewton, LeavesDevelopableShapesAlone) {
	const TriangleMesh sheet = jitteredGrid(41, 41, flatSheet);
	const TriangleMesh maze = without(sheet, 41, [](int column, int row) {
		return row % 4 == 1 && (row % 8 == 1 ? column < 37 : column > 2);
	});
	for (const TriangleMesh& mesh : {sheet, maze, grid(12, 9, quarterCylinder), grid(15, 7, coneBand)}) {
		const PatchAssembly assembly = assembled(mesh);
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, {}).status, Status::NothingToDo);
		EXPECT_EQ(positions, assembly.originalPositions);
	}
}

TEST(ConstrainedNewton, DoesNotDependOnScalePlaceOrRotation) {
	const TriangleMesh mesh = jitteredGrid(21, 21, bumpedCylinder);
	const Positions expected = expectConverges(assembled(mesh), 0.01);
	for (const double scale : {1e-3, 1e4}) {
		const Eigen::Vector3d shift = scale * Eigen::Vector3d(3, -2, 1);
		TriangleMesh other = mesh;
		other.positions = moved(mesh.positions, scale, shift);
		const Positions result = expectConverges(assembled(other), 0.01);
		EXPECT_LT((result - moved(expected, scale, shift)).cwiseAbs().maxCoeff(), 1e-6 * scale);
	}
}

TEST(ConstrainedNewton, DoesNotDependOnTheOrderOfVertices) {
	const TriangleMesh mesh = jitteredGrid(21, 21, bumpedCylinder);
	const Positions expected = expectConverges(assembled(mesh), 0.01);
	std::vector<int> order(mesh.vertexCount());
	std::iota(order.begin(), order.end(), 0);
	std::shuffle(order.begin(), order.end(), std::mt19937(5));
	TriangleMesh shuffled = mesh;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		shuffled.positions.col(order[vertex]) = mesh.positions.col(vertex);
	for (int& vertex : shuffled.triangles.reshaped())
		vertex = order[vertex];
	const Positions result = expectConverges(assembled(shuffled), 0.01);
	EXPECT_LT((result(Eigen::all, order) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConstrainedNewton, GivesTheSameBitsOnEveryRun) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, saddle));
	EXPECT_EQ(expectConverges(assembly, 0.05), expectConverges(assembly, 0.05));
}

TEST(ConstrainedNewton, LeavesHeldPlacesWhereTheyAre) {
	TriangleMesh mesh = jitteredGrid(21, 21, bumpedCylinder);
	for (int vertex = 0; vertex < 21; ++vertex)
		mesh.vertexSelected[vertex] = 1;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, options);
	const Positions positions = expectConverges(assembly, 0.01);
	EXPECT_EQ(positions.leftCols(21), mesh.positions.leftCols(21));
}

TEST(ConstrainedNewton, SaysThatHeldPlacesMakeTheGoalImpossible) {
	const PatchAssembly assembly = heldOutside(2);
	Positions positions = assembly.originalPositions;
	const Measures before = measure(assembly, positions, 1e-4);
	EXPECT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Stalled);
	const Measures after = measure(assembly, positions, 1e-4);
	EXPECT_LT(after.detectFunction, before.detectFunction);
	expectSound(assembly, positions);
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (assembly.placeFixed[place]) {
			EXPECT_EQ(positions.col(place), assembly.originalPositions.col(place));
		}
}

TEST(ConstrainedNewton, EndsAtTheLeastSquaresWhereHeldPlacesAreInTheWay) {
	const PatchAssembly assembly = heldOutside(5);
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Stalled);
	detail::DefectJacobian jacobian(assembly, detail::placeMasses(assembly), 0.1);
	jacobian.freeBorders(true);
	const auto slope = [&](const Positions& at) {
		jacobian.linearize(at);
		return jacobian.applyTransposed(jacobian.scaled(flatDefects(assembly, at), at)).norm();
	};
	EXPECT_LT(slope(positions), 1e-4 * slope(assembly.originalPositions));
}

TEST(ConstrainedNewton, ReachesADevelopableShapeNearRoughOnes) {
	for (const Surface& surface : {Surface(largeSaddle), Surface(vamp), Surface(steepBump), Surface(wave)})
		expectConverges(assembled(noisy(jitteredGrid(13, 13, surface), 0.26)), 0.1);
}

/// A sphere with a hole of four triangles.
TriangleMesh jar() {
	const TriangleMesh mesh = sphere(1, 3);
	return makeMesh(mesh.positions, mesh.triangles.rightCols(mesh.triangleCount() - 4));
}

TEST(ConstrainedNewton, LeavesLessCurvatureByLeastSquares) {
	const PatchAssembly assembly = assembled(jar());
	const auto left = [&](int leastSquares) {
		ConstrainedNewtonOptions options;
		options.tuning.leastSquares = leastSquares;
		options.tuning.curvatureSteps = 0;
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::NeedsCut);
		expectSound(assembly, positions);
		return measure(assembly, positions, 1e-4).totalAbsoluteCurvature;
	};
	EXPECT_LT(left(1), left(0));
}

TEST(ConstrainedNewton, SaysThatAShapeWithAShortRimNeedsACut) {
	expectNeedsCut(assembled(jar()));
}

TEST(ConstrainedNewton, MovesMoreAndBendsLessWithMoreSmoothness) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, wave));
	double last = 0;
	for (const double smoothness : {1e-6, 1e-5, 1e-4}) {
		Positions positions = assembly.originalPositions;
		ConstrainedNewtonOptions options;
		options.smoothness = smoothness;
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
		EXPECT_GT(meanDisplacement(assembly, positions), last);
		last = meanDisplacement(assembly, positions);
	}
}

TEST(ConstrainedNewton, StopsWhenAskedAndLeavesThePositions) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, saddle));
	Positions positions = assembly.originalPositions;
	int calls = 0;
	double last = 0;
	const Progress stopSoon = [&](double done, const std::string&) {
		EXPECT_GE(done, 0);
		EXPECT_LE(done, 1);
		last = done;
		return ++calls < 20;
	};
	EXPECT_EQ(constrainedNewton(assembly, positions, {}, stopSoon).status, Status::Stopped);
	EXPECT_EQ(calls, 20);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(ConstrainedNewton, SaysOfProgressThatItOnlyGrows) {
	for (const TriangleMesh& mesh : {jar(), jitteredGrid(51, 51, wave)}) { // several attempts; several levels
		const PatchAssembly assembly = assembled(mesh);
		Positions positions = assembly.originalPositions;
		double last = 0;
		constrainedNewton(assembly, positions, {}, [&](double done, const std::string&) {
			EXPECT_GE(done, last);
			EXPECT_LE(done, 1);
			last = done;
			return true;
		});
		EXPECT_GT(last, 0.3); // an attempt on another thread may have ended before anyone asked
	}
}

TEST(ConstrainedNewton, EndsAtItsLimitOfIterations) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, saddle));
	Positions positions = assembly.originalPositions;
	ConstrainedNewtonOptions options;
	options.maxIterations = 3;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, options);
	EXPECT_EQ(report.status, Status::LimitReached);
	EXPECT_EQ(report.reason, Reason::AsStatus);
	EXPECT_EQ(report.iterations, 3);
	EXPECT_LT(measure(assembly, positions, 1e-4).totalAbsoluteCurvature,
			  measure(assembly, assembly.originalPositions, 1e-4).totalAbsoluteCurvature);
}

/// A sheet raised so far that it can't lie flat without a cut where its edges are sewn to others.
Eigen::Vector3d bubble(double u, double v) {
	return {u, v, 3 * std::sin(pi * u) * std::sin(pi * v)};
}

/// A sheet beside it, with a ridge that ends at the common edge.
Eigen::Vector3d besideBubble(double u, double v) {
	const double distance = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
	return {1 + u, v, 0.15 * u * std::exp(-20 * distance)};
}

/// Only the first patch ends with curvature; the others are as developable as without it.
void expectOnlyFirstNeedsCut(const PatchAssembly& assembly) {
	Positions positions = assembly.originalPositions;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
	const Measures before = measure(assembly, assembly.originalPositions, 1e-4),
				   after = measure(assembly, positions, 1e-4);
	EXPECT_EQ(report.status, Status::NeedsCut);
	EXPECT_EQ(report.worstPatch, 0);
	EXPECT_EQ(report.reason, report.nearestDevelopable > 0 ? Reason::TooFar : Reason::NeedsCut);
	EXPECT_EQ(report.patchesNeedingCut, 1);
	const int worstPlace = assembly.placeOfCopy[report.worstCopy];
	EXPECT_EQ(Eigen::Vector3d(report.worstPosition.data()), positions.col(worstPlace));
	for (int patch = 1; patch < assembly.patchCount(); ++patch)
		EXPECT_LE(report.patchCurvature[patch], 1e-4);
	EXPECT_LT(after.detectFunction, before.detectFunction);
	EXPECT_LT(after.totalAbsoluteCurvature, before.totalAbsoluteCurvature);
	expectSound(assembly, positions);
}

TEST(ConstrainedNewton, FinishesPatchesBesideOneThatNeedsACut) {
	const auto apart = [](double u, double v) -> Eigen::Vector3d {
		return wave(u, v) + Eigen::Vector3d(0, 5, 0);
	};
	expectOnlyFirstNeedsCut(
		assembled(together(together(jar(), jitteredGrid(15, 15, apart)), jitteredGrid(31, 31, vamp))));
	// Sewn to it, coarse enough to leave the seam to the others and so fine that they have to hold it.
	for (const int columns : {15, 31})
		expectOnlyFirstNeedsCut(assembled(
			together(jitteredGrid(columns, columns, bubble), jitteredGrid(columns, columns, besideBubble))));
}

TEST(ConstrainedNewton, MayTakeNoStepAtAll) {
	for (const int columns : {15, 60}) { // one level, and several
		const PatchAssembly assembly = assembled(jitteredGrid(columns, columns, bumpedCylinder));
		Positions positions = assembly.originalPositions;
		ConstrainedNewtonOptions options;
		options.maxIterations = 0;
		const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, options);
		EXPECT_EQ(report.status, Status::LimitReached);
		EXPECT_EQ(report.iterations, 0);
		EXPECT_EQ(positions, assembly.originalPositions);
	}
}

TEST(ConstrainedNewton, RefusesOptionsOutOfRange) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	Positions positions = assembly.originalPositions;
	const auto refused = [&](auto change) {
		ConstrainedNewtonOptions options;
		change(options);
		EXPECT_THROW(constrainedNewton(assembly, positions, options), InvalidParameter);
	};
	refused([](auto& options) { options.curvatureTolerance = 0; });
	refused([](auto& options) { options.angleTolerance = -1; });
	refused([](auto& options) { options.maxIterations = -1; });
	refused([](auto& options) { options.smoothness = 0; });
	refused([](auto& options) { options.smoothness = std::nan(""); });
	const PatchAssembly closed = assembled(octahedron());
	Positions octahedronPositions = closed.originalPositions;
	EXPECT_THROW(constrainedNewton(closed, octahedronPositions, {}), ClosedPatch);
}

} // namespace
} // namespace developable::test
