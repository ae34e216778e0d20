// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/border_limits.h"
#include "developable/newton/rods.h"
#include "support/finite_differences.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

TEST(Rods, RunAlongBordersSeamsAndCreasesButNotRoundCorners) {
	const PatchAssembly square = assembled(grid(6, 6, flatSheet));
	EXPECT_EQ(detail::rodJoints(square, {}).size(), 4 * 4); // a corner is no joint
	TriangleMesh right = grid(6, 6, flatSheet);
	right.positions.row(0) = 2 - right.positions.row(0).array(); // mirrored, with a seam
	const PatchAssembly sewn = assembled(together(grid(6, 6, flatSheet), right));
	EXPECT_EQ(detail::rodJoints(sewn, {}).size(), 6 * 4 + 2 + 4);
	TriangleMesh roof = grid(6, 6, flatSheet);
	for (auto p : roof.positions.colwise())
		p[2] = std::abs(p[0] - roof.positions(0, 2)); // folded by 90° along a column of points
	EXPECT_EQ(detail::rodJoints(assembled(roof), {}).size(), 4 * 4 - 2 + 4);
	EXPECT_EQ(detail::rodJoints(assembled(roof), {30, 100}).size(), 4 * 4 - 2);
}

TEST(Rods, BendLikeTheCurveThatTheyStandFor) {
	// d = s² along a straight border of length 1: ∫|d''|² ds = 4, short of the halves of the first and last
	// piece.
	const PatchAssembly assembly = assembled(grid(21, 3, flatSheet));
	const Positions& p = assembly.originalPositions;
	double sum = 0, length = 0;
	for (const detail::RodJoint& joint : detail::rodJoints(assembly, {})) {
		if (p(1, joint[0]) != p(1, 0) || p(1, joint[2]) != p(1, 0))
			continue;
		const Eigen::Vector3d values =
			p.row(0)(std::vector<int>{joint[0], joint[1], joint[2]}).array().square();
		sum += std::pow(detail::rodBending(assembly, joint).dot(values), 2);
		length += (p.col(joint[2]) - p.col(joint[0])).norm() / 2;
	}
	EXPECT_GT(length, 0);
	EXPECT_NEAR(sum, 4 * length, 1e-9 * sum);
}

TEST(Rods, MeasureThePartThatHangsTogether) {
	TriangleMesh small = grid(4, 4, flatSheet);
	small.positions *= 0.1;
	small.positions.row(0).array() += 5;
	const PatchAssembly assembly = assembled(together(grid(4, 4, flatSheet), small));
	const Eigen::VectorXd triangleAreas = Eigen::VectorXd::Ones(assembly.triangleCount());
	const Eigen::VectorXd areas = detail::partAreas(assembly, triangleAreas);
	EXPECT_EQ(areas, Eigen::VectorXd::Constant(assembly.placeCount(), 18)); // of 36 triangles
	EXPECT_EQ(detail::partAreas(sewnPatches(4), Eigen::VectorXd::Ones(36))[0], 36);
}

TEST(BorderTurns, HaveTheirGradientInClosedForm) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	const detail::BorderTurns turns(assembly, 0.01);
	const Positions shape = assembly.originalPositions + 0.03 * Positions::Random(3, assembly.placeCount());
	EXPECT_EQ(turns.joints().size(), 16U); // corners included
	for (int joint = 0; joint < 16; ++joint) {
		const Eigen::Vector3d axis = turns.axis(joint, shape);
		const Positions differences = centralDifferences(
			[&](const Positions& p) { return turns.excessAbout(turns.axis(joint, p), joint, p); }, shape);
		Positions gradient = Positions::Zero(3, assembly.placeCount());
		for (int end = 0; end < 3; ++end)
			gradient.col(turns.joints()[joint][end]) += turns.gradientAbout(axis, joint, shape).col(end);
		EXPECT_LT((gradient - differences).norm(), 1e-6 * differences.norm());
		EXPECT_NEAR(std::max(0.0, turns.excessAbout(axis, joint, shape)), turns.excess(shape)[joint], 1e-12);
	}
}

} // namespace
} // namespace developable::test
