// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a panel does not depend on how finely it is meshed.
#include "developable/panels/panel_test.h"

#include "developable/flatten/flatten.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::PanelLimits;
using detail::PanelVerdict;

PanelLimits within(double maxDisplacement) {
	PanelLimits limits;
	limits.maxDisplacement = limits.meanDisplacement = maxDisplacement;
	return limits;
}

PanelVerdict verdictOn(const TriangleMesh& mesh, double maxDisplacement) {
	return testPanel(mesh, within(maxDisplacement));
}

TEST(PanelTest, ofManyPlacesSaysTheSameAsOfFew) {
	for (const Surface& surface : {sphereCap(1), sphereCap(0.6), Surface(vamp)}) {
		const TriangleMesh few = grid(19, 19, surface), many = grid(61, 61, surface);
		const double needed = verdictOn(few, 100).maxDisplacement;
		ASSERT_GT(needed, 0);
		for (const double share : {0.2, 1.5}) {
			const PanelVerdict ofFew = verdictOn(few, share * needed);
			const PanelVerdict ofMany = verdictOn(many, share * needed);
			EXPECT_EQ(ofFew.isPanel(), share > 1);
			EXPECT_EQ(ofMany.isPanel(), share > 1);
			EXPECT_TRUE(ofMany.disk);
			if (share > 1) {
				EXPECT_NEAR(ofMany.meanDisplacement, ofFew.meanDisplacement, 0.3 * ofFew.meanDisplacement);
			}
		}
	}
}

/// The borders of a saddle are too long for any sheet of its size: with all the room there is it takes folds.
TEST(PanelTest, isNoneThatCrumples) {
	const PanelVerdict ofSaddle = verdictOn(grid(19, 19, saddle), 100);
	EXPECT_EQ(ofSaddle.obstacle, detail::Obstacle::Crumples);
	EXPECT_FALSE(ofSaddle.isPanel());
	EXPECT_TRUE(ofSaddle.disk);
	EXPECT_EQ(verdictOn(grid(19, 19, sphereCap(1)), 100).obstacle, detail::Obstacle::None);
	EXPECT_EQ(verdictOn(jitteredGrid(19, 19, flatSheet), 100).obstacle, detail::Obstacle::None);
}

/// A sheet with a slit from the middle of its long side, whose sides lie upon each other but for the tip.
TriangleMesh withOverlappingSlit(int edges) {
	constexpr int columns = 12, rows = 41;
	TriangleMesh mesh =
		grid(columns, rows, [](double u, double v) { return Eigen::Vector3d(u, 6 * v, 0.3 * u * u); });
	const int row = rows / 2, first = mesh.vertexCount();
	const Eigen::Vector3d over(0, 0.02, 0.01);
	Positions positions(3, first + edges);
	positions.leftCols(first) = mesh.positions;
	for (int column = 0; column < edges; ++column) {
		const int vertex = row * columns + column;
		positions.col(first + column) = mesh.positions.col(vertex) - over;
		positions.col(vertex) += over;
	}
	for (int t = 0; t < mesh.triangleCount(); ++t) // those above have the new ones
		if (mesh.positions(1, mesh.triangles.col(t)[0]) + mesh.positions(1, mesh.triangles.col(t)[1]) +
				mesh.positions(1, mesh.triangles.col(t)[2]) >
			9)
			for (int& vertex : mesh.triangles.col(t))
				if (vertex / columns == row && vertex % columns < edges)
					vertex = first + vertex % columns;
	return makeMesh(positions, mesh.triangles);
}

/// Seams are drawn anew, and notches that are left are closed.
TEST(PanelTest, isNotHardOnNotchesOfTheBorder) {
	for (const int edges : {2, 6}) {
		const PatchAssembly assembly = assembled(withOverlappingSlit(edges));
		EXPECT_TRUE(flattenPatches(assembly, assembly.originalPositions).pieces.front().overlapping);
		const PanelVerdict verdict = verdictOn(withOverlappingSlit(edges), 100);
		EXPECT_EQ(verdict.isPanel(), edges == 2);
		EXPECT_EQ(verdict.obstacle, edges == 2 ? detail::Obstacle::None : detail::Obstacle::Overlaps);
	}
}

using detail::Obstacle;

/// What the quick look leaves to the test has the test's verdict.
TEST(PanelTest, ofWhatIsPromisingIsTheSame) {
	const TriangleMesh cap = grid(25, 25, sphereCap(0.6));
	const double needed = verdictOn(cap, 100).maxDisplacement;
	for (const double share : {0.4, 1.5}) {
		const PanelVerdict verdict = testIfPromising(cap, within(share * needed));
		EXPECT_EQ(verdict.obstacle, share > 1 ? Obstacle::None : Obstacle::TooFar);
		EXPECT_EQ(verdict.maxDisplacement, verdictOn(cap, share * needed).maxDisplacement);
	}
}

TEST(PanelTest, strainedFarMoreThanTheMoveMakesUpForIsUnpromising) {
	const TriangleMesh cap = grid(25, 25, sphereCap(1));
	const double needed = verdictOn(cap, 100).maxDisplacement;
	EXPECT_EQ(testIfPromising(cap, within(needed / 10)).obstacle, Obstacle::Unpromising);
	EXPECT_EQ(verdictOn(cap, needed / 10).obstacle, Obstacle::TooFar);
	EXPECT_FALSE(testIfPromising(cap, within(needed / 10)).isPanel());
}

/// More than a whole turn round an axis, hardly rising: nearly a flat ring, whose ends lie upon each other.
TEST(PanelTest, overlappingByMuchIsUnpromising) {
	const auto turns = [](double angle) {
		return grid(9, 61, [=](double u, double v) {
			return Eigen::Vector3d((1 + u) * std::cos(angle * v), (1 + u) * std::sin(angle * v), 0.2 * v);
		});
	};
	EXPECT_EQ(testIfPromising(turns(7.5), within(0.2)).obstacle, Obstacle::Unpromising);
	EXPECT_EQ(verdictOn(turns(7.5), 0.2).obstacle, Obstacle::Overlaps);
	EXPECT_TRUE(testIfPromising(turns(5.5), within(0.2)).isPanel());
}

/// Which would take as long to look at as to test.
TEST(PanelTest, ofFewPlacesIsNeverUnpromising) {
	EXPECT_EQ(testIfPromising(grid(9, 9, sphereCap(1)), within(1e-3)).obstacle, Obstacle::TooFar);
}

} // namespace
} // namespace developable::test
