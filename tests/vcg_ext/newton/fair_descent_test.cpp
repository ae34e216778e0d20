// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/fair_descent.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

constexpr detail::CurvatureGoal usualGoal{1e-4, 1e-4, 1};

detail::Unfairness unfairnessOf(const PatchAssembly& assembly, double fairness) {
	return {assembly, detail::shapeSmoothness(fairness), {}, 0};
}

detail::FairDescent descentOf(const detail::Unfairness& unfairness) {
	return {unfairness, 3e-6, usualGoal, 200, 0, {}, std::make_shared<detail::WorkBudget>()};
}

TEST(Unfairness, OfAFlatSheetIsItsDistanceInBothNorms) {
	const PatchAssembly sheet = assembled(jitteredGrid(9, 9, flatSheet));
	const detail::Unfairness unfairness = unfairnessOf(sheet, 0.3);
	EXPECT_NEAR(unfairness.at(sheet.originalPositions), 0, 1e-15);
	Positions lifted = sheet.originalPositions;
	lifted.row(2).array() += 0.1;
	EXPECT_NEAR(unfairness.at(lifted), 2 * 0.01, 1e-12);
	// Each norm alone would bring it back: so does their sum.
	EXPECT_LT((lifted + unfairness.step(lifted).move - sheet.originalPositions).norm(), 1e-9);
}

TEST(Unfairness, CountsPlacesThatSlideAlongTheSurfaceForNothing) {
	const PatchAssembly sheet = assembled(jitteredGrid(9, 9, flatSheet));
	const detail::Unfairness unfairness = unfairnessOf(sheet, 0.3);
	Positions slid = sheet.originalPositions;
	slid.col(4 * 9 + 4) += Eigen::Vector3d(0.02, -0.01, 0); // inside
	EXPECT_NEAR(unfairness.at(slid), 0, 1e-15);
}

TEST(Unfairness, GrowsWithTheSquareOfTheScale) {
	TriangleMesh mesh = noisy(jitteredGrid(9, 9, wave), 0.1);
	const PatchAssembly small = assembled(mesh);
	mesh.positions *= 3;
	const PatchAssembly large = assembled(mesh);
	const Positions moved = 1.01 * small.originalPositions;
	const double ofSmall = unfairnessOf(small, 0.3).at(moved);
	EXPECT_GT(ofSmall, 0);
	EXPECT_NEAR(unfairnessOf(large, 0.3).at(3 * moved), 9 * ofSmall, 1e-9 * ofSmall);
}

TEST(FairDescent, FindsFairerDevelopableShapes) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(21, 21, vamp), 0.1));
	Positions positions = assembly.originalPositions;
	ASSERT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Converged);
	const detail::Unfairness unfairness = unfairnessOf(assembly, 0.3);
	const double before = unfairness.at(positions);
	detail::FairDescent descent = descentOf(unfairness);
	EXPECT_EQ(descent.run(positions, {}), detail::Ending::Reached);
	EXPECT_LT(unfairness.at(positions), 0.8 * before);
	EXPECT_LT(angleDefects(assembly, positions).cwiseAbs().sum(), 1e-4);
	expectSound(assembly, positions);
	EXPECT_GT(descent.iterations(), 0);
}

TEST(FairDescent, StopsWhenAskedTo) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(21, 21, vamp), 0.1));
	Positions positions = assembly.originalPositions;
	ASSERT_EQ(constrainedNewton(assembly, positions, {}).status, Status::Converged);
	const Positions before = positions;
	const detail::Unfairness unfairness = unfairnessOf(assembly, 0.3);
	detail::FairDescent descent = descentOf(unfairness);
	EXPECT_EQ(descent.run(positions, [](double, const std::string&) { return false; }),
			  detail::Ending::Stopped);
	EXPECT_EQ(positions, before);
}

} // namespace
} // namespace developable::test
