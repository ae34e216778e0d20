// SPDX-License-Identifier: GPL-3.0-or-later
// Local steps repair what a whole step has spoilt near few places, and leave the others where they are.
#include "developable/newton/local_steps.h"

#include "developable/newton/newton_attempt.h"
#include "developable/newton/normal_steps.h"
#include "newton_problems.h"
#include "threads_allowed.h"

#include <set>

namespace developable::test {
namespace {

constexpr int sheetColumns = 41;

/// Developable to the last bits, as its edges run along the rulings.
PatchAssembly ruledSheet() {
	return assembled(jitteredGrid(sheetColumns, sheetColumns, quarterCylinder, 0));
}

/// With some places moved along their normals by a share of an edge.
Positions withPeaks(const PatchAssembly& assembly, const std::set<int>& places, double share = 0.3) {
	Positions positions = assembly.originalPositions;
	const Positions normals = placeNormals(assembly, positions);
	for (const int place : places)
		positions.col(place) += share * meanEdgeLength(assembly) * normals.col(place);
	return positions;
}

class LocalStepsOnASheet : public ::testing::Test {
protected:
	const PatchAssembly assembly = ruledSheet();
	const detail::NewtonProblem problem = problemOf(assembly);
	const int one = sheetColumns * 10 + 10, other = sheetColumns * 30 + 30;

	std::optional<detail::Shape> improved(const Positions& ahead, double before) const {
		return detail::LocalSteps(problem, 1).improved(problem.shapeAt(ahead), before);
	}
	double squared(const Positions& positions) const {
		return problem.shapeAt(positions).scaledDefects.squaredNorm();
	}
};

TEST_F(LocalStepsOnASheet, FlattenAPeakAndMoveNothingElse) {
	const Positions ahead = withPeaks(assembly, {one});
	const double before = squared(ahead) / 10;
	const std::optional<detail::Shape> found = improved(ahead, before);
	ASSERT_TRUE(found);
	EXPECT_LT(found->scaledDefects.squaredNorm(), 0.1 * before);
	expectSound(assembly, found->positions);
	// A peak spoils its own angle defect and its neighbours', and two rings round those may move.
	const double reach = 6 * meanEdgeLength(assembly);
	int moved = 0, movedFar = 0;
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (found->positions.col(place) != ahead.col(place)) {
			const Eigen::Vector3d fromPeak =
				assembly.originalPositions.col(place) - assembly.originalPositions.col(one);
			++moved;
			movedFar += fromPeak.norm() > reach;
		}
	EXPECT_EQ(movedFar, 0);
	EXPECT_GT(moved, 0);
}

/// Parts have their share of the curvature that all may be left with, and no more.
TEST_F(LocalStepsOnASheet, FlattenWhatIsLessThanThePatchMayHave) {
	const Positions ahead = withPeaks(assembly, {one}, 1e-3);
	const detail::Shape start = problem.shapeAt(ahead);
	detail::NewtonProblem lenient(assembly, {2 * start.curvature, 1}, {}, 0);
	lenient.setSmoothness(3e-6);
	ASSERT_TRUE(lenient.shapeAt(ahead).reached);
	const auto found = detail::LocalSteps(lenient, 1).improved(start, start.squaredDefects() / 10);
	ASSERT_TRUE(found);
	EXPECT_LT(found->curvature, 0.1 * start.curvature);
}

TEST_F(LocalStepsOnASheet, LeaveWhatIsNotLocal) {
	Positions everywhere = assembly.originalPositions;
	everywhere += 0.05 * meanEdgeLength(assembly) * Positions::Random(3, assembly.placeCount());
	EXPECT_FALSE(improved(everywhere, squared(everywhere) / 4));
	EXPECT_FALSE(improved(assembly.originalPositions, 1)); // nothing is left there
}

TEST_F(LocalStepsOnASheet, AreTheSameWhateverGoesOnElsewhere) {
	const Positions alone = withPeaks(assembly, {one}), both = withPeaks(assembly, {one, other});
	const double before = squared(alone) / 10;
	const std::optional<detail::Shape> ofAlone = improved(alone, before), ofBoth = improved(both, before);
	ASSERT_TRUE(ofAlone && ofBoth);
	EXPECT_LT(ofBoth->scaledDefects.squaredNorm(), 0.1 * before);
	const int half = assembly.placeCount() / 2;
	EXPECT_TRUE(ofAlone->positions.leftCols(half) == ofBoth->positions.leftCols(half));
}

TEST_F(LocalStepsOnASheet, AreTheSameOnAnyNumberOfThreads) {
	const Positions both = withPeaks(assembly, {one, other});
	const auto onThreads = [&](const char* threads) {
		const ThreadsAllowed allowed(threads);
		return improved(both, squared(both) / 20)->positions;
	};
	EXPECT_TRUE(onThreads("1") == onThreads("3"));
}

TEST_F(LocalStepsOnASheet, HoldWhatIsHeld) {
	PatchAssembly held = assembly;
	held.placeFixed[one + 1] = 1;
	const detail::NewtonProblem problemWithHeld = problemOf(held);
	const Positions ahead = withPeaks(held, {one});
	const detail::Shape start = problemWithHeld.shapeAt(ahead);
	const std::optional<detail::Shape> found =
		detail::LocalSteps(problemWithHeld, 1).improved(start, start.scaledDefects.squaredNorm() / 10);
	ASSERT_TRUE(found);
	EXPECT_EQ(found->positions.col(one + 1), ahead.col(one + 1));
}

/// A peak of the original itself has to go down by more than it may.
TEST_F(LocalStepsOnASheet, KeepTheBoundOnDisplacements) {
	PatchAssembly peaked = assembly;
	peaked.originalPositions = withPeaks(assembly, {one});
	const detail::NewtonProblem ofPeak = problemOf(peaked);
	const detail::Shape start = ofPeak.shapeAt(peaked.originalPositions);
	const auto farthest = [&](double bound) {
		const auto found = detail::LocalSteps(ofPeak, bound).improved(start, start.squaredDefects() / 10);
		return found ? found->farthest : -1;
	};
	const double bound = 0.1 * meanEdgeLength(assembly);
	EXPECT_GT(farthest(1), bound);
	EXPECT_GT(farthest(bound), 0.5 * bound);
	EXPECT_LE(farthest(bound), bound);
}

TEST_F(LocalStepsOnASheet, FollowAWholeStepThatLeavesMoreThanItMay) {
	const Positions start = withPeaks(assembly, {one}, 0.02), peak = withPeaks(assembly, {other}, 0.3);
	const Progress silent;
	detail::NewtonRun run(problem, start, 10, silent);
	const double before = run.shape().squaredDefects();
	const detail::LocalSteps steps(problem, 1);
	ASSERT_GT(squared(peak), before);
	EXPECT_EQ(steps.step(run, peak - start, 1.01 * squared(peak) / before), 0); // as much may be left
	EXPECT_EQ(run.shape().squaredDefects(), before);
	EXPECT_EQ(steps.step(run, peak - start, 1), 1);
	EXPECT_LT(run.shape().squaredDefects(), 0.1 * before);
	EXPECT_LT((run.shape().positions.col(one) - assembly.originalPositions.col(one)).norm(),
			  1e-6 * meanEdgeLength(assembly)); // as the whole step has it
}

/// A surface of few flat facets, each of many triangles: whole steps spoil places on them.
PatchAssembly facetedSheet(const Surface& surface, int facets) {
	return assembled(jitteredGrid(
		sheetColumns, sheetColumns,
		[&](double u, double v) {
			const double i = std::min(std::floor(u * facets), facets - 1.0), a = u * facets - i;
			const double j = std::min(std::floor(v * facets), facets - 1.0), b = v * facets - j;
			const auto corner = [&](double x, double y) {
				return surface((i + x) / facets, (j + y) / facets);
			};
			return Eigen::Vector3d((1 - b) * ((1 - a) * corner(0, 0) + a * corner(1, 0)) +
								   b * ((1 - a) * corner(0, 1) + a * corner(1, 1)));
		},
		0.25));
}

TEST(RestorationWithLocalSteps, TakesFewerFactorisations) {
	const auto stepsOf = [](const PatchAssembly& assembly, int rounds) {
		NewtonTuning tuning;
		tuning.localRounds = rounds;
		detail::NewtonProblem problem = problemOf(assembly, tuning);
		const detail::AttemptResult end =
			detail::restoreFrom(problem, assembly.originalPositions, 3e-6, 200, {});
		EXPECT_EQ(end.ending, detail::Ending::Reached);
		expectSound(assembly, end.positions);
		return end.iterations;
	};
	for (const PatchAssembly& assembly : {facetedSheet(largeSaddle, 3), facetedSheet(largeSaddle, 5),
										  facetedSheet(bumpedCylinder, 7), facetedSheet(bumpedCylinder, 11)})
		EXPECT_LT(stepsOf(assembly, 4), stepsOf(assembly, 0));
}

/// How steps along the normals end, with so many rounds of local steps or without.
struct End {
	detail::Ending ending;
	int steps;
	Positions positions;
};

End endOf(const PatchAssembly& assembly, int rounds) {
	NewtonTuning tuning;
	tuning.localPlaces = 0;
	tuning.localRounds = rounds;
	detail::NewtonProblem problem = problemOf(assembly, tuning);
	problem.jacobian().freeBorders(true);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 300, silent);
	detail::NormalSteps steps(problem, run, 1);
	steps.allowLocalSteps();
	const detail::Ending ending = steps.run();
	expectSound(assembly, run.shape().positions);
	return {ending, run.iterations(), run.shape().positions};
}

TEST(NormalStepsWithLocalSteps, TakeFewerFactorisations) {
	for (const int facets : {5, 8, 10}) {
		const PatchAssembly assembly = facetedSheet(bumpedCylinder, facets);
		const End with = endOf(assembly, 4), without = endOf(assembly, 0);
		EXPECT_EQ(with.ending, detail::Ending::Reached);
		EXPECT_EQ(without.ending, detail::Ending::Reached);
		EXPECT_LT(with.steps, without.steps) << facets;
	}
}

TEST(NormalStepsWithLocalSteps, BeginAgainWithoutWhereTheyAreStuck) {
	const PatchAssembly assembly = facetedSheet(largeSaddle, 2);
	const End with = endOf(assembly, 4), without = endOf(assembly, 0);
	EXPECT_EQ(with.ending, without.ending);
	EXPECT_GT(with.steps, without.steps);
	EXPECT_TRUE(with.positions == without.positions);
}

} // namespace
} // namespace developable::test
