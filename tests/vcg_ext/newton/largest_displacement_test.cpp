// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/newton_checks.h"

namespace developable::test {
namespace {

double farthest(const PatchAssembly& assembly, const Positions& positions) {
	return (positions - assembly.originalPositions).colwise().norm().maxCoeff();
}

ConstrainedNewtonReport runWithin(const PatchAssembly& assembly, double bound, Positions& positions) {
	ConstrainedNewtonOptions options;
	options.maxDisplacement = bound;
	positions = assembly.originalPositions;
	return constrainedNewton(assembly, positions, options);
}

TEST(LargestDisplacement, IsKeptToTheLastBitWhateverTheResult) {
	for (const Surface& surface : {Surface(wave), Surface(largeSaddle), Surface(steepBump), sphereCap(1)})
		for (const int columns : {16}) {
			const PatchAssembly assembly = assembled(jitteredGrid(columns, columns, surface));
			const double start = measure(assembly, assembly.originalPositions, 1e-4).totalAbsoluteCurvature;
			for (const double share : {1e-9, 0.003, 0.02, 0.1}) {
				const double bound = share * boxDiagonal(assembly.originalPositions);
				Positions positions;
				const ConstrainedNewtonReport report = runWithin(assembly, bound, positions);
				EXPECT_LE(farthest(assembly, positions), bound);
				expectSound(assembly, positions);
				const double left = measure(assembly, positions, 1e-4).totalAbsoluteCurvature;
				EXPECT_LE(left, start);
				if (report.status == Status::Converged)
					EXPECT_LE(left, 1e-4);
				else
					EXPECT_EQ(report.status, Status::NeedsCut);
				if (report.reason == Reason::TooFar) {
					EXPECT_GT(report.nearestDevelopable, bound);
				}
			}
		}
}

TEST(LargestDisplacement, IsKeptOverAllLevels) {
	const PatchAssembly assembly = assembled(jitteredGrid(45, 45, largeSaddle));
	for (const double share : {0.02, 0.1}) {
		const double bound = share * boxDiagonal(assembly.originalPositions);
		Positions positions;
		runWithin(assembly, bound, positions);
		EXPECT_LE(farthest(assembly, positions), bound);
		EXPECT_GT(farthest(assembly, positions), 0.5 * bound);
		expectSound(assembly, positions);
	}
}

TEST(LargestDisplacement, IsKeptByTheShortestSteps) {
	// Developable but for noise, which so much more than the bound would take away.
	const PatchAssembly assembly = assembled(noisy(grid(12, 12, quarterCylinder), 1e-4));
	Positions free;
	ASSERT_EQ(runWithin(assembly, -1, free).status, Status::Converged);
	const double needed = farthest(assembly, free);
	ASSERT_LT(needed, 1e-3 / 11);
	for (const double share : {0.03, 0.3, 0.6}) {
		Positions positions;
		const ConstrainedNewtonReport report = runWithin(assembly, share * needed, positions);
		EXPECT_LE(farthest(assembly, positions), share * needed);
		EXPECT_GT(farthest(assembly, positions), 0.5 * share * needed);
		EXPECT_LT(measure(assembly, positions, 1e-4).detectFunction,
				  measure(assembly, assembly.originalPositions, 1e-4).detectFunction);
		EXPECT_EQ(report.status, Status::NeedsCut);
	}
}

TEST(LargestDisplacement, IsKeptOverAllLevelsFarFromTheOrigin) {
	// Where a last bit of the coordinates is more than a thousandth of the bound.
	TriangleMesh mesh = jitteredGrid(16, 16, steepBump);
	mesh.positions.array() += 1e9;
	const PatchAssembly assembly = assembled(mesh);
	ConstrainedNewtonOptions options;
	options.tuning.coarsest = 30;
	for (const double bound : {1e-6, 3e-6, 1e-5, 1e-4, 1e-3}) {
		options.maxDisplacement = bound;
		Positions positions = assembly.originalPositions;
		constrainedNewton(assembly, positions, options);
		EXPECT_LE(farthest(assembly, positions), bound);
	}
}

TEST(LargestDisplacement, OfNothingMovesNothingAndSaysHowFarTheNearestIs) {
	const PatchAssembly assembly = assembled(jitteredGrid(16, 16, bumpedCylinder));
	Positions positions;
	const ConstrainedNewtonReport report = runWithin(assembly, 0, positions);
	EXPECT_EQ(positions, assembly.originalPositions);
	EXPECT_EQ(report.status, Status::NeedsCut);
	EXPECT_EQ(report.reason, Reason::TooFar);
	Positions free;
	EXPECT_EQ(runWithin(assembly, 1e9, free).status, Status::Converged);
	EXPECT_NEAR(report.nearestDevelopable, farthest(assembly, free), 0.1 * farthest(assembly, free));
	ASSERT_EQ(report.patchVerdicts.size(), 1);
	EXPECT_EQ(report.patchVerdicts[0].nearestDevelopable, report.nearestDevelopable);
}

TEST(LargestDisplacement, OfNextToNothingSaysHowFarTheNearestIs) {
	const PatchAssembly assembly = assembled(jitteredGrid(16, 16, bumpedCylinder));
	for (const double share : {1e-14, 1e-10, 1e-8, 1e-6}) {
		Positions positions;
		const ConstrainedNewtonReport report =
			runWithin(assembly, share * boxDiagonal(assembly.originalPositions), positions);
		EXPECT_EQ(report.reason, Reason::TooFar);
		EXPECT_GT(report.nearestDevelopable, 1e-3 * boxDiagonal(assembly.originalPositions));
	}
}

TEST(LargestDisplacement, LeavesWaysToShapesThatAreNearerThanTheFirstFound) {
	for (const Surface& surface : {Surface(steepBump), Surface(largeSaddle), Surface(bumpedCylinder)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(31, 31, surface));
		Positions positions;
		ASSERT_EQ(runWithin(assembly, 1e9, positions).status, Status::Converged);
		const double bound = 0.9 * farthest(assembly, positions);
		EXPECT_EQ(runWithin(assembly, bound, positions).status, Status::Converged);
		EXPECT_LE(farthest(assembly, positions), bound);
	}
}

TEST(LargestDisplacement, IsAShareOfEachPartsDiagonalByDefault) {
	TriangleMesh small = jitteredGrid(12, 12, steepBump), large = small;
	small.positions *= 1e-2;
	small.positions.row(0).array() += 10;
	const PatchAssembly assembly = assembled(together(large, small));
	Positions positions = assembly.originalPositions;
	constrainedNewton(assembly, positions, {});
	for (const AssemblyPart& part : partsOf(assembly)) {
		const Positions moved = positions(Eigen::all, part.wholePlace) - part.assembly.originalPositions;
		EXPECT_LE(moved.colwise().norm().maxCoeff(), 0.15 * boxDiagonal(part.assembly.originalPositions));
	}
}

TEST(LargestDisplacement, HoldsForStartsThatAreElsewhere) {
	const PatchAssembly assembly = assembled(jitteredGrid(12, 12, bumpedCylinder));
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.02;
	Positions positions = assembly.originalPositions;
	positions.row(2).array() += 1;
	constrainedNewton(assembly, positions, options);
	EXPECT_LE(farthest(assembly, positions), 0.02);
	options.maxDisplacement = std::nan("");
	EXPECT_THROW(constrainedNewton(assembly, positions, options), InvalidParameter);
}

TEST(LargestDisplacement, IsPreferablyBelowAnotherBoundWhereThatIsEasy) {
	int lowered = 0;
	for (const Surface& surface :
		 {Surface(saddle), Surface(wave), Surface(steepBump), Surface(vamp), sphereCap(1)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(14, 14, surface));
		ConstrainedNewtonOptions options;
		options.tuning.preferredMove = 0;
		Positions free = assembly.originalPositions, chosen = free;
		if (constrainedNewton(assembly, free, options).status != Status::Converged)
			continue;
		const double diagonal = boxDiagonal(assembly.originalPositions);
		options.tuning.preferredMove = 0.98 * farthest(assembly, free) / diagonal;
		EXPECT_EQ(constrainedNewton(assembly, chosen, options).status, Status::Converged);
		expectSound(assembly, chosen);
		EXPECT_LE(farthest(assembly, chosen), farthest(assembly, free));
		if (farthest(assembly, chosen) > options.tuning.preferredMove * diagonal) {
			EXPECT_EQ(chosen, free); // where it leads nowhere the shape is as it was
			continue;
		}
		++lowered;
		EXPECT_LT(meanDisplacement(assembly, chosen), 1.05 * meanDisplacement(assembly, free));

		options.tuning.preferredReach = options.tuning.pullBackReach = 1.01; // as it was where it is too far
		chosen = assembly.originalPositions;
		constrainedNewton(assembly, chosen, options);
		EXPECT_EQ(chosen, free);
	}
	EXPECT_GE(lowered, 1);
}

TEST(LargestDisplacement, IsPulledBackOnTheFinestLevelToo) {
	int lowered = 0;
	for (const Surface& surface : {Surface(saddle), Surface(wave), Surface(largeSaddle), Surface(vamp)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(26, 26, surface));
		const double diagonal = boxDiagonal(assembly.originalPositions);
		ConstrainedNewtonOptions options;
		options.tuning.coarsest = 150;
		options.tuning.preferredMove = 0;
		Positions free = assembly.originalPositions, chosen = free;
		if (constrainedNewton(assembly, free, options).status != Status::Converged)
			continue;
		options.tuning.preferredMove = 0.9 * farthest(assembly, free) / diagonal;
		EXPECT_EQ(constrainedNewton(assembly, chosen, options).status, Status::Converged);
		expectSound(assembly, chosen);
		lowered += farthest(assembly, chosen) <= options.tuning.preferredMove * diagonal;
	}
	EXPECT_GE(lowered, 3);
}

TEST(LargestDisplacement, IsToldFromTheWayWhereOnlyThatIsAsked) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, steepBump));
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.5;
	Positions free = assembly.originalPositions;
	ASSERT_EQ(constrainedNewton(assembly, free, options).status, Status::Converged);
	const double mean = meanDisplacement(assembly, free);

	options.tuning.wayMean = 1.2 * mean / options.maxDisplacement;
	Positions near = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, near, options).status, Status::Converged);
	EXPECT_TRUE(near == free); // a way that is short enough is the same

	options.tuning.wayMean = 0.5 * mean / options.maxDisplacement;
	Positions tooFar = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, tooFar, options).status, Status::NeedsCut);
	EXPECT_LT(meanDisplacement(assembly, tooFar), mean);
	for (const int coarsest : {100, 1500}) { // on coarser levels, too
		options.tuning.coarsest = coarsest;
		options.tuning.wayMean = 1e6;
		options.tuning.wayFarthest = 0.1;
		tooFar = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, tooFar, options).status, Status::NeedsCut);
	}
}

} // namespace
} // namespace developable::test
