// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/constrained_newton.h"

#include "support/newton_checks.h"

#include <Eigen/SparseCholesky>

namespace developable::test {
namespace {

/// Two halves of a bump with a seam along the middle, mirror images of each other.
PatchAssembly sewnPatches(int columns) {
	const TriangleMesh left = jitteredGrid(columns, columns, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 2 - right.positions.row(0).array();
	return assembled(together(left, right));
}

int eulerCharacteristic(const PatchAssembly& assembly) {
	int sum = 0;
	for (const Patch& patch : assembly.patches)
		sum += patch.eulerCharacteristic();
	return sum;
}

TEST(Coarsening, KeepsTopologySeamsAndPositions) {
	for (const PatchAssembly& fine : {sewnPatches(31), assembled(jitteredGrid(41, 41, steepBump)),
									  assembled(withTwoHoles(41, bumpedCylinder))}) {
		const PartialAssembly coarse = detail::Coarsening(fine).coarsen(fine.placeCount() / 4);
		EXPECT_EQ(coarse.assembly.placeCount(), fine.placeCount() / 4);
		EXPECT_EQ(coarse.assembly.patchCount(), fine.patchCount());
		EXPECT_EQ(eulerCharacteristic(coarse.assembly), eulerCharacteristic(fine));
		EXPECT_EQ(coarse.assembly.originalPositions,
				  fine.originalPositions(Eigen::all, coarse.wholePlace).eval());
		for (int place = 0; place < coarse.assembly.placeCount(); ++place)
			EXPECT_EQ(coarse.assembly.placeAssembling[place], fine.placeAssembling[coarse.wholePlace[place]]);
		for (const auto& places : coarse.assembly.trianglePlaces.colwise())
			EXPECT_TRUE(places[0] != places[1] && places[1] != places[2] && places[2] != places[0]);
		EXPECT_GT(smallestAngle(coarse.assembly, coarse.assembly.originalPositions), 7 * pi / 180);
		EXPECT_EQ(flippedTriangles(coarse.assembly, coarse.assembly.originalPositions), 0);
	}
}

TEST(Coarsening, KeepsCornersAndAllOfTheAreaOfASheet) {
	const PatchAssembly sheet = assembled(jitteredGrid(41, 41, flatSheet));
	const PartialAssembly coarse = detail::Coarsening(sheet).coarsen(100);
	EXPECT_NEAR(copyAreas(coarse.assembly, coarse.assembly.originalPositions).sum(), 1, 1e-12);
}

TEST(Coarsening, TakesHeldPlacesOutOnlyFromAmongHeldOnes) {
	TriangleMesh mesh = jitteredGrid(41, 41, saddle);
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		mesh.vertexSelected[vertex] = vertex % 41 < 20;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly fine = assembled(mesh, options);
	const PartialAssembly coarse = detail::Coarsening(fine).coarsen(500);
	std::vector<char> kept(fine.placeCount(), 0);
	for (int place = 0; place < coarse.assembly.placeCount(); ++place) {
		kept[coarse.wholePlace[place]] = 1;
		EXPECT_EQ(coarse.assembly.placeFixed[place], fine.placeFixed[coarse.wholePlace[place]]);
	}
	int rimKept = 0, innerKept = 0;
	for (int row = 0; row < 41; ++row) {
		rimKept += kept[41 * row + 19]; // has neighbours that are free
		innerKept += kept[41 * row + 10];
	}
	EXPECT_GT(rimKept, 35);
	EXPECT_LT(innerKept, 20);
}

TEST(Prolongation, KeepsAffineDisplacements) {
	const PatchAssembly fine = sewnPatches(31);
	const PartialAssembly coarse = detail::Coarsening(fine).coarsen(500);
	Eigen::Matrix3d slope;
	slope << 0.3, -0.2, 1, 0.5, 0.1, 0.4, -0.7, 0.2, 0.6;
	const Positions expected = slope * fine.originalPositions;
	const Positions result = detail::prolonged(fine, coarse, expected(Eigen::all, coarse.wholePlace).eval());
	EXPECT_LT((result - expected).cwiseAbs().maxCoeff(),
			  0.02); // of 1: the surface is curved, so not quite free
	const PatchAssembly sheet = assembled(jitteredGrid(31, 31, flatSheet));
	const PartialAssembly coarseSheet = detail::Coarsening(sheet).coarsen(300);
	const Positions affine = slope * sheet.originalPositions;
	EXPECT_LT(
		(detail::prolonged(sheet, coarseSheet, affine(Eigen::all, coarseSheet.wholePlace).eval()) - affine)
			.cwiseAbs()
			.maxCoeff(),
		1e-4);
}

TEST(NormalSystem, IsTheProductThatItStandsFor) {
	const PatchAssembly assembly = sewnPatches(12);
	const detail::BendingMetric metric(assembly, Eigen::VectorXd::Constant(assembly.patchCount(), 1e-4));
	detail::DefectJacobian jacobian(assembly, metric.placeMass());
	detail::NormalSystem system(metric.matrix());
	for (const double noise : {0.0, 0.01}) { // the second time with the pattern of the first
		const Positions positions =
			assembly.originalPositions + noise * Positions::Random(3, assembly.placeCount());
		jacobian.linearize(positions);
		const Positions normals = placeNormals(assembly, positions);
		const Eigen::MatrixXd along = jacobian.along(normals).toDense();
		const Eigen::MatrixXd w = SparseMatrix(metric.matrix().selfadjointView<Eigen::Lower>());
		const Eigen::MatrixXd expected =
			along.transpose() * along + 0.3 * w.cwiseProduct(normals.transpose() * normals);
		const Eigen::MatrixXd found = system.fill(jacobian.along(normals), normals, 0.3).toDense();
		const Eigen::MatrixXd lower = expected.triangularView<Eigen::Lower>();
		EXPECT_LT((found - lower).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
	}
}

TEST(NormalSteps, TakeAwayCurvatureOfShortWaves) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(25, 25, quarterCylinder), 0.02));
	const detail::CurvatureGoal goal{1e-4, 1e-4};
	const detail::NewtonOutcome outcome =
		detail::NormalSteps(assembly, detail::Soundness(assembly), 3e-6, goal, 0, {})
			.run(assembly.originalPositions, 1, 100);
	EXPECT_EQ(outcome.status, Status::Converged);
	EXPECT_LE(angleDefects(assembly, outcome.positions).cwiseAbs().sum(), 1e-4);
	EXPECT_LT(meanDisplacement(assembly, outcome.positions), 0.002);
	expectSound(assembly, outcome.positions);
}

TEST(MultilevelNewton, ReachesADevelopableShapeNearSmoothOnes) {
	expectConverges(assembled(jitteredGrid(51, 51, sphereCap(1))), 0.015);
	expectConverges(assembled(jitteredGrid(51, 51, largeSaddle)), 0.055);
	expectConverges(assembled(jitteredGrid(51, 51, bumpedCylinder)), 0.006);
	expectConverges(assembled(jitteredGrid(51, 51, wave)), 0.011);
	expectConverges(assembled(jitteredGrid(51, 51, vamp)), 0.015);
	expectConverges(assembled(jitteredGrid(51, 51, steepBump)), 0.04);
}

TEST(MultilevelNewton, ReachesADevelopableShapeThroughNoiseHolesAndSeams) {
	expectConverges(assembled(noisy(jitteredGrid(51, 51, wave), 0.02)), 0.011);
	expectConverges(assembled(noisy(jitteredGrid(51, 51, largeSaddle), 0.02)), 0.06);
	expectConverges(assembled(withTwoHoles(51, bumpedCylinder)), 0.006);
	expectConverges(sewnPatches(41), 0.02);
}

TEST(MultilevelNewton, MovesNoFartherThanWithoutLevels) {
	const PatchAssembly assembly = assembled(jitteredGrid(45, 45, bumpedCylinder));
	const detail::NewtonOutcome direct =
		detail::solveDirectly(assembly, assembly.originalPositions, 3e-6, {1e-4, 1e-4}, 200, {});
	ASSERT_EQ(direct.status, Status::Converged);
	expectConverges(assembly, 1.1 * meanDisplacement(assembly, direct.positions));
}

TEST(MultilevelNewton, DoesWithLittleMemory) {
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

TEST(MultilevelNewton, GivesTheSameBitsOnEveryRunAndLeavesHeldPlaces) {
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

TEST(MultilevelNewton, SaysThatAShapeWithAShortRimNeedsACut) {
	TriangleMesh mesh = sphere(1, 5);
	mesh.triangles = mesh.triangles.rightCols(mesh.triangleCount() - 64).eval();
	const PatchAssembly assembly = assembled(makeMesh(mesh.positions, mesh.triangles));
	ASSERT_GT(assembly.placeCount(), 3000);
	expectNeedsCut(assembly);
}

TEST(MultilevelNewton, StopsOnAnyLevelAndLeavesThePositions) {
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

TEST(SparseCholesky, SolvesAsEigensOwnFactorisationDoes) {
	const PatchAssembly assembly = assembled(jitteredGrid(31, 31, bumpedCylinder));
	const SparseMatrix lower =
		detail::BendingMatrix(assembly, detail::placeMasses(assembly), Eigen::VectorXd::Constant(1, 1e-4))
			.lower();
	SparseCholesky ours;
	ASSERT_TRUE(ours.factorize(lower));
	const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> eigens(lower);
	const Eigen::MatrixXd rightHandSide = assembly.originalPositions.transpose();
	const Eigen::MatrixXd expected = eigens.solve(rightHandSide);
	EXPECT_LT((ours.solve(rightHandSide) - expected).norm(), 1e-9 * expected.norm());
	SparseSolver iterative(1);
	ASSERT_TRUE(iterative.factorize(lower));
	EXPECT_TRUE(iterative.iterates());
	EXPECT_LT((iterative.solve(rightHandSide) - expected).norm(), 0.02 * expected.norm());
	SparseSolver exact(1e9);
	ASSERT_TRUE(exact.factorize(lower));
	EXPECT_FALSE(exact.iterates());
	SparseMatrix indefinite = lower;
	indefinite.coeffRef(7, 7) = -1;
	EXPECT_FALSE(SparseCholesky().factorize(indefinite));
}

} // namespace
} // namespace developable::test
