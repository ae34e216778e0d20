// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/border_separation.h"

#include "developable/flatten/flatten.h"
#include "developable/newton/displacement_metric.h"
#include "newton_problems.h"
#include "support/cone_ramp.h"
#include "threads_allowed.h"

namespace developable::test {
namespace {

int overlapping(const PatchAssembly& assembly, const Positions& positions) {
	return flattenPatches(assembly, positions).report.overlappingPieces;
}

/// Slits across a band of 61 columns from its inner border, as darts that do not open: the sides touch.
TriangleMesh withSlits(const TriangleMesh& band, int rows) {
	constexpr int columns = 61, apart = 5;
	Positions positions = band.positions;
	Eigen::Matrix3Xi triangles = band.triangles;
	for (int column = apart; column < columns - 1; column += apart) {
		const auto first = static_cast<int>(positions.cols());
		positions.conservativeResize(3, first + rows);
		for (int row = 0; row < rows; ++row)
			positions.col(first + row) = band.positions.col(row * columns + column);
		for (int t = 0; t < band.triangleCount(); ++t) // those behind it have these
			for (int& vertex : triangles.col(t))
				if (t % (2 * (columns - 1)) / 2 == column && vertex < rows * columns &&
					vertex % columns == column)
					vertex = first + vertex / columns;
	}
	return makeMesh(positions, triangles);
}

TEST(BorderSeparation, OpensWhatCoversItselfByALittleAndNoMore) {
	for (const double more : {0.01, 0.03, 0.06}) {
		const PatchAssembly assembly = assembled(coneRamp(more));
		const double bound = 0.1 * boxDiagonal(assembly.originalPositions);
		ASSERT_EQ(overlapping(assembly, assembly.originalPositions), 1);
		detail::NewtonProblem problem = problemOf(assembly);
		problem.jacobian().freeBorders(true);
		const Progress silent;
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::BorderSeparation separation(problem, run, bound);
		ASSERT_TRUE(separation.isNeeded());
		EXPECT_EQ(separation.run(), detail::Ending::Reached) << more;
		const Positions& apart = run.shape().positions;
		EXPECT_EQ(overlapping(assembly, apart), 0) << more;
		EXPECT_LE(angleDefects(assembly, apart).cwiseAbs().sum(), 1e-4);
		EXPECT_GT(farthestMove(assembly, apart), 0.05 * more);
		EXPECT_LT(farthestMove(assembly, apart), more);
		expectSound(assembly, apart);
	}
}

/// Which by rounding cross, or do not, at every step.
TEST(BorderSeparation, LeavesAloneWhatOnlyTouches) {
	const Progress silent;
	for (const double more : {-0.1, 0.04, 0.05, 0.06}) {
		const PatchAssembly assembly = assembled(withSlits(coneRamp(more), 3));
		ASSERT_EQ(overlapping(assembly, assembly.originalPositions), more > 0 ? 1 : 0);
		detail::NewtonProblem problem = problemOf(assembly);
		problem.jacobian().freeBorders(true);
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::BorderSeparation separation(problem, run, 0.1 * boxDiagonal(assembly.originalPositions));
		ASSERT_EQ(separation.isNeeded(), more > 0);
		EXPECT_TRUE(more < 0 || separation.run() == detail::Ending::Reached) << more;
		EXPECT_EQ(overlapping(assembly, run.shape().positions), 0) << more;
		EXPECT_LT(farthestMove(assembly, run.shape().positions),
				  std::max(more / 4, 1e-9)); // no farther than it takes
	}
}

TEST(BorderSeparation, LeavesWhatNoMoveWithinTheBoundWouldOpen) {
	const Progress silent;
	// One of the two covers itself by too much, which is known beforehand or found in vain.
	const PatchAssembly assembly = assembled(together(coneRamp(0.02, 0.05), coneRamp(3, 0.2)));
	const double bound = 0.01 * boxDiagonal(assembly.originalPositions);
	for (const double reach : {NewtonTuning().separationReach, 1e3}) {
		NewtonTuning tuning;
		tuning.separationReach = reach;
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		problem.jacobian().freeBorders(true);
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::BorderSeparation separation(problem, run, bound);
		ASSERT_TRUE(separation.isNeeded());
		EXPECT_EQ(separation.run(), detail::Ending::Reached) << reach;
		EXPECT_EQ(overlapping(assembly, run.shape().positions), 1) << reach;
		EXPECT_LE(angleDefects(assembly, run.shape().positions).cwiseAbs().sum(), 1e-4);
		EXPECT_LE(farthestMove(assembly, run.shape().positions), bound);
	}
	const PatchAssembly deep = assembled(coneRamp(3, 0.2));
	detail::NewtonProblem hopeless = problemOf(deep);
	detail::NewtonRun nowhere(hopeless, deep.originalPositions, 200, silent);
	EXPECT_FALSE(detail::BorderSeparation(hopeless, nowhere, bound).isNeeded());
	EXPECT_EQ(nowhere.shape().positions, deep.originalPositions);
}

/// Both cross still where the deeper of the two can go no farther within the bound.
TEST(BorderSeparation, LeavesTheWorstOfThoseThatCrossAndNotTheOthers) {
	const Progress silent;
	NewtonTuning tuning;
	tuning.separationReach = 1e3; // that none is left beforehand
	const TriangleMesh deep = coneRamp(0.2), shallow = coneRamp(0.1);
	for (const bool deepFirst : {true, false}) {
		const PatchAssembly assembly =
			assembled(deepFirst ? together(deep, shallow) : together(shallow, deep));
		const double bound = 0.005 * boxDiagonal(assembly.originalPositions);
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		problem.jacobian().freeBorders(true);
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::BorderSeparation separation(problem, run, bound);
		EXPECT_EQ(separation.run(), detail::Ending::Reached);
		const FlatPatterns flat = flattenPatches(assembly, run.shape().positions);
		EXPECT_EQ(flat.pieces[0].overlapping, deepFirst);
		EXPECT_EQ(flat.pieces[1].overlapping, !deepFirst);
		EXPECT_LE(angleDefects(assembly, run.shape().positions).cwiseAbs().sum(), 1e-4);
		EXPECT_LE(farthestMove(assembly, run.shape().positions), bound);
	}
}

/// What became developable, with the same bits for any number of threads.
TEST(BorderSeparation, FollowsWhereAWholeRunEndsWithOverlaps) {
	const PatchAssembly assembly = assembled(noisy(coneRamp(0.03), 0.02));
	ConstrainedNewtonOptions options;
	options.tuning.separationSteps = 0;
	Positions covered = assembly.originalPositions, apart = covered, alone = covered;
	ASSERT_EQ(constrainedNewton(assembly, covered, options).status, Status::Converged);
	ASSERT_EQ(overlapping(assembly, covered), 1);
	EXPECT_EQ(constrainedNewton(assembly, apart, {}).status, Status::Converged);
	EXPECT_EQ(overlapping(assembly, apart), 0);
	EXPECT_LE(angleDefects(assembly, apart).cwiseAbs().sum(), 1e-4);
	EXPECT_LT(meanDisplacement(assembly, apart), meanDisplacement(assembly, covered) + 0.01);
	const ThreadsAllowed one("1");
	constrainedNewton(assembly, alone, {});
	EXPECT_EQ(alone, apart);
}

TEST(BorderSeparation, LeavesEveryBitOfWhatDoesNotOverlap) {
	const PatchAssembly assembly = assembled(noisy(coneRamp(-0.1), 0.02));
	ConstrainedNewtonOptions options;
	options.tuning.separationSteps = 0;
	Positions without = assembly.originalPositions, with = without;
	constrainedNewton(assembly, without, options);
	constrainedNewton(assembly, with, {});
	EXPECT_EQ(with, without);
}

} // namespace
} // namespace developable::test
