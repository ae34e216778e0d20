// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/penalty/penalty_method.h"

#include "developable/geometry/geometry.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace developable::test {
namespace {

TEST(PenaltyMethod, LowersTheDetectFunctionAndCountsItsSteps) {
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(saddle), sphereCap(1.0)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(16, 16, surface));
		Positions positions = assembly.originalPositions;
		const double before = detectFunction(angleDefects(assembly, positions));
		const OptimizationReport report = penaltyMethod(assembly, positions, {});
		EXPECT_LT(detectFunction(angleDefects(assembly, positions)), 0.7 * before);
		EXPECT_GE(report.iterations, 1);
		EXPECT_LE(report.iterations, 200);
	}
}

TEST(PenaltyMethod, RunsToItsLimitWhenBothTolerancesAreZero) {
	const PatchAssembly assembly = assembled(jitteredGrid(12, 12, saddle));
	Positions positions = assembly.originalPositions;
	PenaltyMethodOptions options;
	options.angleTolerance = options.relativeChange = 0;
	options.maxIterations = 30;
	const OptimizationReport report = penaltyMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::LimitReached);
	EXPECT_EQ(report.iterations, 30);
}

TEST(PenaltyMethod, StopsWhereAnOuterStepChangesLittle) {
	const PatchAssembly assembly = assembled(jitteredGrid(12, 12, saddle));
	Positions positions = assembly.originalPositions;
	PenaltyMethodOptions options;
	options.relativeChange = 0.05;
	EXPECT_EQ(penaltyMethod(assembly, positions, options).status, Status::Stalled);
}

TEST(PenaltyMethod, ConvergesWhenTheToleranceIsWide) {
	const PatchAssembly assembly = assembled(jitteredGrid(12, 12, bumpedCylinder));
	Positions positions = assembly.originalPositions;
	PenaltyMethodOptions options;
	options.angleTolerance = 0.8 * measure(assembly, positions, 0).maxAngleDefect;
	EXPECT_EQ(penaltyMethod(assembly, positions, options).status, Status::Converged);
	EXPECT_LE(measure(assembly, positions, 0).maxAngleDefect, options.angleTolerance);
}

TEST(PenaltyMethod, LeavesADevelopableShapeAlone) {
	const PatchAssembly assembly = assembled(grid(10, 10, quarterCylinder));
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(penaltyMethod(assembly, positions, {}).status, Status::NothingToDo);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(PenaltyMethod, HoldsFixedPlacesStill) {
	PatchOptions patchOptions;
	patchOptions.fixBoundary = true;
	const PatchAssembly assembly = assembled(jitteredGrid(12, 12, bumpedCylinder), patchOptions);
	Positions positions = assembly.originalPositions;
	penaltyMethod(assembly, positions, {});
	int fixed = 0;
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (assembly.placeFixed[place]) {
			EXPECT_EQ(positions.col(place), assembly.originalPositions.col(place));
			++fixed;
		}
	EXPECT_EQ(fixed, 4 * 11);
	EXPECT_GT((positions - assembly.originalPositions).norm(), 0);
}

TEST(PenaltyMethod, DoesNotDependOnWhereTheShapeIsOrHowLarge) {
	const TriangleMesh mesh = jitteredGrid(10, 10, bumpedCylinder);
	TriangleMesh elsewhere = mesh;
	elsewhere.positions = moved(mesh.positions, 37, Eigen::Vector3d(10, -20, 5));
	PenaltyMethodOptions options;
	options.maxIterations = 3; // rounding grows with the number of steps
	const PatchAssembly a = assembled(mesh), b = assembled(elsewhere);
	Positions atA = a.originalPositions, atB = b.originalPositions;
	penaltyMethod(a, atA, options);
	penaltyMethod(b, atB, options);
	EXPECT_LT((moved(atA, 37, Eigen::Vector3d(10, -20, 5)) - atB).cwiseAbs().maxCoeff(), 1e-6);
	EXPECT_GT((atA - a.originalPositions).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(PenaltyMethod, GivesTheSameResultOnEveryRun) {
	const PatchAssembly assembly = assembled(jitteredGrid(10, 12, saddle));
	Positions first = assembly.originalPositions, second = first;
	penaltyMethod(assembly, first, {});
	penaltyMethod(assembly, second, {});
	EXPECT_EQ(first, second);
}

TEST(PenaltyMethod, LeavesThePositionsAsTheyWereWhenStopped) {
	const PatchAssembly assembly = assembled(jitteredGrid(10, 10, saddle));
	Positions positions = assembly.originalPositions;
	int calls = 0;
	const auto stopAtTheSeventh = [&](double fraction, const std::string& message) {
		EXPECT_GE(fraction, 0);
		EXPECT_LE(fraction, 1);
		EXPECT_FALSE(message.empty());
		return ++calls < 7;
	};
	EXPECT_EQ(penaltyMethod(assembly, positions, {}, stopAtTheSeventh).status, Status::Stopped);
	EXPECT_EQ(calls, 7);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(PenaltyMethod, RefusesClosedPatchesAndNothingFree) {
	const PatchAssembly closed = assembled(together(octahedron(), grid(3, 3, saddle)));
	Positions positions = closed.originalPositions;
	try {
		penaltyMethod(closed, positions, {});
		FAIL() << "a closed patch was accepted";
	} catch (const ClosedPatch& error) {
		EXPECT_NE(std::string(error.what()).find("1 of 2"), std::string::npos) << error.what();
	}
	TriangleMesh mesh = jitteredGrid(5, 5, saddle);
	mesh.vertexSelected.assign(25, 1);
	PatchOptions patchOptions;
	patchOptions.fixSelected = true;
	const PatchAssembly held = assembled(mesh, patchOptions);
	positions = held.originalPositions;
	EXPECT_THROW(penaltyMethod(held, positions, {}), NothingFree);
}

TEST(PenaltyMethod, StallsAtWhatIsNotANumber) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 6, saddle));
	Positions positions = assembly.originalPositions;
	positions(0, 14) = std::nan("");
	PenaltyMethodOptions options;
	options.maxIterations = std::numeric_limits<int>::max();
	EXPECT_EQ(penaltyMethod(assembly, positions, options).status, Status::Stalled);
}

TEST(PenaltyMethod, RefusesOptionsOutOfRange) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	Positions positions = assembly.originalPositions;
	const auto refused = [&](auto change) {
		PenaltyMethodOptions options;
		change(options);
		EXPECT_THROW(penaltyMethod(assembly, positions, options), InvalidParameter);
	};
	refused([](auto& options) { options.angleTolerance = -1e-9; });
	refused([](auto& options) { options.angleTolerance = std::nan(""); });
	refused([](auto& options) { options.relativeChange = -1; });
	refused([](auto& options) { options.relativeChange = std::nan(""); });
	refused([](auto& options) { options.maxIterations = -1; });
	EXPECT_EQ(positions, assembly.originalPositions);
}

} // namespace
} // namespace developable::test
