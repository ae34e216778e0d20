// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local/local_method.h"

#include "support/local_method_cases.h"

#include <gtest/gtest.h>
#include <limits>

namespace developable::test {
namespace {

TEST(LocalMethod, DescentLowersTWithEveryMoveAndEndsByItself) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions descent;
	descent.descent = true;
	descent.angleTolerance = 1e-5; // out of reach
	Positions careful = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, careful, descent);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_LT(report.iterations, descent.maxOperations / 2);
	EXPECT_GT(report.setAside, 0);
	EXPECT_LT(measured(assembly, careful).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
	// One move alone lowers G, for T holds all of G that it can change.
	descent.maxOperations = 1;
	Positions once = assembly.originalPositions;
	localMethod(assembly, once, descent);
	EXPECT_LT(measured(assembly, once).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
}

/// Σ over edges of the squared difference of the displacements of its ends.
double unevenness(const PatchAssembly& assembly, const Positions& positions) {
	const Positions moves = positions - assembly.originalPositions;
	double sum = 0;
	for (const auto& edge : assembly.edgePlaces.colwise())
		sum += (moves.col(edge[0]) - moves.col(edge[1])).squaredNorm();
	return sum / moves.squaredNorm();
}

/// Runs until G is as low as a bound, and no longer.
Positions runUntil(const PatchAssembly& assembly, LocalMethodOptions options, double bound) {
	long tooFew = 0, enough = options.maxOperations;
	Positions result;
	while (enough - tooFew > 1) {
		options.maxOperations = (tooFew + enough) / 2;
		Positions positions = assembly.originalPositions;
		localMethod(assembly, positions, options);
		if (measured(assembly, positions).detectFunction > bound) {
			tooFew = options.maxOperations;
		} else {
			enough = options.maxOperations;
			result = positions;
		}
	}
	return result;
}

TEST(LocalMethod, SmoothingEvensOutTheDisplacementsAtEqualDetectFunction) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions options;
	options.descent = true;
	options.maxOperations = 20000;
	const double bound = 0.6 * measured(assembly, assembly.originalPositions).detectFunction;
	const Positions plain = runUntil(assembly, options, bound);
	options.smoothing = 0.01;
	const Positions smooth = runUntil(assembly, options, bound);
	ASSERT_GT(plain.size(), 0);
	ASSERT_GT(smooth.size(), 0);
	EXPECT_LT(unevenness(assembly, smooth), 0.9 * unevenness(assembly, plain));
	EXPECT_LT(roughness(assembly, smooth), roughness(assembly, plain));
}

TEST(LocalMethod, MovesSeamsWhenTheyMayMoveTogether) {
	const PatchAssembly assembly = sewnSheets();
	ASSERT_EQ(assembly.patchCount(), 2);
	ASSERT_EQ(assembly.assemblingPlaceCount(), 9);
	LocalMethodOptions options;
	options.descent = true;
	Positions fixed = assembly.originalPositions, together = fixed;
	localMethod(assembly, fixed, options);
	options.assemblingVertices = AssemblingVertices::MoveTogether;
	localMethod(assembly, together, options);
	double seamMove = 0;
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (assembly.placeAssembling[place]) {
			EXPECT_EQ(fixed.col(place), assembly.originalPositions.col(place));
			seamMove =
				std::max(seamMove, (together.col(place) - assembly.originalPositions.col(place)).norm());
		}
	EXPECT_GT(seamMove, 1e-3);
	EXPECT_LT(measured(assembly, together).detectFunction, 0.8 * measured(assembly, fixed).detectFunction);
}

TEST(LocalMethod, EndsLowerWhereSeamsMoveThanWhereTheyStay) {
	for (const double height : {0.7, 1.0, 1.3}) {
		TriangleMesh left = jitteredGrid(13, 13, saddle);
		left.positions.row(2) *= height;
		TriangleMesh right = left;
		right.positions.row(0) = 2 - right.positions.row(0).array();
		const PatchAssembly assembly = assembled(together(left, right));
		for (const long operations : {0L, 1L, 2000L, 500000L}) {
			LocalMethodOptions options;
			options.maxOperations = operations;
			Positions fixed = assembly.originalPositions, moving = fixed;
			const bool enough = converged(localMethod(assembly, fixed, options).status);
			options.assemblingVertices = AssemblingVertices::MoveTogether;
			const LocalMethodReport report = localMethod(assembly, moving, options);
			EXPECT_LE(report.iterations, operations);
			const double start = measured(assembly, assembly.originalPositions).detectFunction,
						 ofFixed = measured(assembly, fixed).detectFunction,
						 ofMoving = measured(assembly, moving).detectFunction;
			EXPECT_LE(ofMoving, start);
			if (operations >= 500000 && !enough) {
				EXPECT_LT(ofMoving, ofFixed);
			}
		}
	}
}

TEST(LocalMethod, DoesNotConvergeWithWhatIsNotANumber) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 6, saddle));
	LocalMethodOptions options;
	options.angleTolerance = 1;
	for (const int place : {0, 14, 35}) {
		Positions positions = assembly.originalPositions;
		positions(0, place) = std::nan("");
		EXPECT_FALSE(converged(localMethod(assembly, positions, options).status)) << place;
	}
}

TEST(LocalMethod, RefusesOptionsOutOfRange) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	Positions positions = assembly.originalPositions;
	const auto refused = [&](auto change) {
		LocalMethodOptions options;
		change(options);
		EXPECT_THROW(localMethod(assembly, positions, options), InvalidParameter);
	};
	refused([](auto& options) { options.angleTolerance = -1e-9; });
	refused([](auto& options) { options.angleTolerance = std::nan(""); });
	refused([](auto& options) { options.maxOperations = -1; });
	refused([](auto& options) { options.maxDisplacement = -0.5; });
	refused([](auto& options) { options.maxDisplacement = std::nan(""); });
	refused([](auto& options) { options.smoothing = -1; });
	refused([](auto& options) { options.smoothing = std::numeric_limits<double>::infinity(); });
	EXPECT_EQ(positions, assembly.originalPositions);
}

} // namespace
} // namespace developable::test
