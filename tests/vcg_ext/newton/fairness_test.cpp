// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/fair_shape.h"
#include "developable/newton/rods.h"
#include "developable/newton/shortest_steps.h"
#include "newton_problems.h"

#include <random>

namespace developable::test {
namespace {

/// The most that a border turns more than before at one vertex, rad; every border vertex counts, corners too.
double mostTurnGained(const PatchAssembly& assembly, const Positions& positions) {
	const detail::BorderTurns turns(assembly, 0);
	return turns.excess(positions).maxCoeff();
}

TEST(Fairness, BordersDoNotKink) {
	for (const Surface& surface :
		 {Surface(sphereCap(1)), Surface(bumpedCylinder), Surface(wave), Surface(vamp)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(21, 21, surface));
		Positions positions = assembly.originalPositions;
		ASSERT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Converged);
		EXPECT_LT(mostTurnGained(assembly, positions), 5 * pi / 180);
	}
}

TEST(Fairness, BordersOfWhatIsNearlyDevelopableDoNotKink) {
	for (const double middle : {0.5, 0.8, 1.0})
		for (const double height : {3e-5, 3e-4, 1e-3}) {
			const PatchAssembly assembly = assembled(grid(41, 41, bumpedCone(height, middle)));
			Positions positions = assembly.originalPositions;
			EXPECT_TRUE(converged(constrainedNewton(assembly, positions, {}).status));
			EXPECT_LT(mostTurnGained(assembly, positions), 0.5 * pi / 180);
		}
}

TEST(Fairness, ADartDoesNotOpenBeyondAFullTurn) {
	// A saddle with a slit from the border to its middle: flat, more than a full turn is left round its tip.
	TriangleMesh mesh = grid(15, 15, largeSaddle);
	Positions positions(3, mesh.vertexCount() + 7);
	positions << mesh.positions, mesh.positions.middleCols(7 * 15, 7);
	for (int t = 0; t < mesh.triangleCount(); ++t) // those above the slit get vertices of their own
		for (int corner = 0; corner < 3; ++corner) {
			const int vertex = mesh.triangles(corner, t);
			if (t / 28 == 7 && vertex >= 7 * 15 && vertex < 7 * 15 + 7)
				mesh.triangles(corner, t) = mesh.vertexCount() + vertex - 7 * 15;
		}
	for (int i = 0; i < 7; ++i) // a hair open, so that its sides are two
		positions(1, mesh.vertexCount() + i) += 1e-3 * (7 - i);
	const PatchAssembly assembly = assembled(makeMesh(positions, mesh.triangles));
	Positions shape = assembly.originalPositions;
	ASSERT_EQ(constrainedNewton(assembly, shape, {}).status, Status::Converged);
	EXPECT_LE(borderAngles(assembly, shape).maxCoeff(), 2 * pi + 1e-4);
}

TEST(Fairness, WhatIsDevelopableButForRoundingHardlyMoves) {
	// Strips of two cells, with walls between that are open at one end.
	const TriangleMesh maze = without(grid(31, 31, coneBand), 31, [](int column, int row) {
		return column % 3 == 2 && (column % 2 == 0 ? row >= 2 : row < 28);
	});
	for (TriangleMesh mesh :
		 {grid(31, 31, coneBand), grid(31, 31, quarterCylinder), grid(31, 31, flatSheet), maze}) {
		const Positions exact = mesh.positions;
		mesh.positions = exact.cast<float>().cast<double>();
		const double rounding = (mesh.positions - exact).cwiseAbs().maxCoeff();
		const PatchAssembly assembly = assembled(mesh);
		Positions positions = assembly.originalPositions;
		ConstrainedNewtonOptions options;
		options.curvatureTolerance = 1e-6;
		constrainedNewton(assembly, positions, options);
		EXPECT_LT(angleDefects(assembly, positions).cwiseAbs().sum(), 1e-6);
		EXPECT_LE((positions - assembly.originalPositions).cwiseAbs().maxCoeff(), 100 * rounding);
	}
}

TEST(Fairness, ShortestStepsLeaveAloneWhatNeedsMore) {
	const PatchAssembly assembly = assembled(jitteredGrid(11, 11, saddle));
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	EXPECT_EQ(detail::ShortestSteps(problem, run).run(), detail::Ending::Stuck);
	EXPECT_EQ(run.shape().positions, assembly.originalPositions);
}

TEST(Fairness, ShortestStepsForeseeWhatNeedsMore) {
	// Every vertex could lose its own angle defect, but not all together.
	const PatchAssembly assembly = assembled(grid(41, 41, bumpedCylinder));
	const Progress silent;
	const auto steps = [&](int foresight) {
		NewtonTuning tuning;
		tuning.shortestMove = 0.1;
		tuning.shortestForesight = foresight;
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		problem.jacobian().freeBorders(true);
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		EXPECT_EQ(detail::ShortestSteps(problem, run).run(), detail::Ending::Stuck);
		return run.iterations();
	};
	EXPECT_EQ(steps(NewtonTuning().shortestForesight), 0);
	EXPECT_GT(steps(0), 0);
}

TEST(Fairness, ShortestStepsEndWhereRoundingDoes) {
	TriangleMesh mesh = grid(31, 31, coneBand);
	mesh.positions = mesh.positions.cast<float>().cast<double>();
	const PatchAssembly assembly = assembled(mesh);
	detail::NewtonProblem problem(assembly, {1e-300, 1e-300}, {}, 0);
	problem.jacobian().freeBorders(true);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	EXPECT_EQ(detail::ShortestSteps(problem, run).run(), detail::Ending::Stuck);
	EXPECT_LT(run.shape().curvature, 1e-9);
	EXPECT_LT(run.iterations(), NewtonTuning().shortestSteps / 2);
}

/// x² − y² over squares with alternating diagonals, vertices in another order for each seed.
TriangleMesh symmetricSaddle(int seed) {
	const int n = 21;
	TriangleMesh mesh = grid(n, n, [](double u, double v) {
		return Eigen::Vector3d(u, v, 0.2 * (std::pow(u - 0.5, 2) - std::pow(v - 0.5, 2)));
	});
	for (int cell = 0; cell < (n - 1) * (n - 1); ++cell)
		if ((cell % (n - 1) + cell / (n - 1)) % 2 == 1) {
			const int a = cell / (n - 1) * n + cell % (n - 1);
			mesh.triangles.col(2 * cell) << a, a + 1, a + n;
			mesh.triangles.col(2 * cell + 1) << a + 1, a + n + 1, a + n;
		}
	std::vector<int> order(n * n);
	for (int i = 0; i < n * n; ++i)
		order[i] = i;
	std::mt19937 random(seed);
	for (int i = n * n - 1; i > 0; --i)
		std::swap(order[i], order[random() % (i + 1)]);
	Positions positions(3, n * n);
	for (int i = 0; i < n * n; ++i)
		positions.col(order[i]) = mesh.positions.col(i);
	for (int& vertex : mesh.triangles.reshaped())
		vertex = order[vertex];
	return makeMesh(positions, mesh.triangles);
}

TEST(Fairness, TheOrderOfVerticesDecidesNothingOnASymmetricShape) {
	double least = 1e300, most = 0;
	for (int seed = 0; seed < 10; ++seed) {
		const PatchAssembly assembly = assembled(symmetricSaddle(seed));
		Positions positions = assembly.originalPositions;
		ASSERT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Converged);
		least = std::min(least, meanDisplacement(assembly, positions));
		most = std::max(most, meanDisplacement(assembly, positions));
	}
	EXPECT_LE(most, 1.05 * least);
}

TEST(Fairness, SmoothsTheSurfacesOwnDetail) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(25, 25, bumpedCylinder), 0.1));
	double last = roughness(assembly, assembly.originalPositions);
	for (const double fairness : {0.0, 0.2, 0.5}) {
		Positions positions = assembly.originalPositions;
		ConstrainedNewtonOptions options;
		options.fairness = fairness;
		ASSERT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
		EXPECT_LT(roughness(assembly, positions), (fairness > 0 ? 0.8 : 1.05) * last) << fairness;
		last = roughness(assembly, positions);
	}
	ConstrainedNewtonOptions options;
	options.fairness = 1.5;
	Positions positions = assembly.originalPositions;
	EXPECT_THROW(constrainedNewton(assembly, positions, options), InvalidParameter);
	EXPECT_EQ(positions, assembly.originalPositions);
}

PatchAssembly fairShapeOf(const PatchAssembly& assembly, double shapeSmoothness,
						  const detail::CurvatureGoal& goal = {1e-4, 1e-4}) {
	return detail::fairShape(detail::Unfairness(assembly, shapeSmoothness, {}, 0), goal, {});
}

TEST(Fairness, FairShapeIsSmootherAndOnTheSurface) {
	const PatchAssembly smooth = assembled(jitteredGrid(25, 25, bumpedCylinder));
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(25, 25, bumpedCylinder), 0.1));
	const double noise = (assembly.originalPositions - smooth.originalPositions).colwise().norm().maxCoeff();
	const PatchAssembly fair = fairShapeOf(assembly, 1e-6);
	EXPECT_LT(roughness(fair, fair.originalPositions), 0.7 * roughness(assembly, assembly.originalPositions));
	EXPECT_LT(distancesToSurface(fair.originalPositions, smooth.originalPositions, smooth.trianglePlaces)
				  .maxCoeff(),
			  noise);
}

/// The mean angle between neighbours within a patch, rad.
double meanBend(const PatchAssembly& assembly, const Positions& positions, int patch) {
	double sum = 0;
	int count = 0;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		if (assembly.across(h) < 0 || assembly.patchOfTriangle[h / 3] != patch)
			continue;
		const double cosine = unitNormal(assembly, positions, h / 3)
								  .dot(unitNormal(assembly, positions, assembly.across(h) / 3));
		sum += std::acos(std::min(1.0, cosine));
		++count;
	}
	return sum / count;
}

TEST(Fairness, SmallPanelsBecomeAsFairAsLargeOnes) {
	const int columns = 25;
	const TriangleMesh whole = noisy(jitteredGrid(columns, columns, bumpedCylinder), 0.1);
	const auto isNarrow = [](int column, int) { return column < 5; };
	const PatchAssembly assembly = assembled(
		together(without(whole, columns, isNarrow),
				 without(whole, columns, [&](int column, int row) { return !isNarrow(column, row); })));
	ASSERT_EQ(assembly.patchCount(), 2);
	const PatchAssembly fair = fairShapeOf(assembly, 1e-6);
	double left[2];
	for (const int patch : {0, 1})
		left[patch] = meanBend(assembly, fair.originalPositions, patch) /
					  meanBend(assembly, assembly.originalPositions, patch);
	EXPECT_LT(left[1], 1.3 * left[0]);
	EXPECT_LT(left[0], 1.3 * left[1]);
}

TEST(Fairness, FairShapeKeepsWhatIsFlatOrHeldOrBounded) {
	// A flat sheet is as smooth as it can be.
	const PatchAssembly sheet = assembled(jitteredGrid(9, 9, flatSheet));
	const PatchAssembly fairSheet = fairShapeOf(sheet, 1e-5);
	EXPECT_LT((fairSheet.originalPositions - sheet.originalPositions).norm(), 1e-9);
	PatchAssembly held = assembled(noisy(jitteredGrid(15, 15, wave), 0.1));
	for (int place = 0; place < held.placeCount(); place += 3)
		held.placeFixed[place] = 1;
	const PatchAssembly fair = fairShapeOf(held, 1e-6);
	EXPECT_NE(fair.originalPositions, held.originalPositions);
	for (int place = 0; place < held.placeCount(); place += 3)
		EXPECT_EQ(fair.originalPositions.col(place), held.originalPositions.col(place));
	const PatchAssembly near = fairShapeOf(held, 1e-6, {1e-4, 1e-4, 1e-6});
	EXPECT_LE((near.originalPositions - held.originalPositions).colwise().norm().maxCoeff(), 1e-6);
}

} // namespace
} // namespace developable::test
