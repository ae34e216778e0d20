// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// A ring cut from a cone whose half angle has this sine.
Surface frustum(double sine) {
	return [sine](double u, double v) -> Eigen::Vector3d {
		const double radius = 0.5 + 0.5 * v;
		return {radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u),
				0.5 * v * std::sqrt(1 / (sine * sine) - 1)};
	};
}

TEST(PanelCuts, ATubeIsCutOnceAndBothSidesOfTheCutAreASeam) {
	const TriangleMesh mesh = ring(24, 9, tube);
	const FlatPatterns patterns = flattened(mesh);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
	EXPECT_EQ(patterns.pieces[0].holes, 1);
	EXPECT_EQ(patterns.pieces[0].cuts, 1);
	EXPECT_EQ(patterns.vertexCount(), mesh.vertexCount() + 9);
	ASSERT_EQ(patterns.seams.size(), 1u);
	EXPECT_EQ(patterns.seams[0].halfEdges[0].size(), 8u);
	EXPECT_NEAR(patterns.seams[0].length[0], 3, 1e-11); // straight along the tube: the shortest way
	EXPECT_LT(patterns.seams[0].mismatch(), 1e-11);
	EXPECT_EQ(patterns.report.notes.size(), 1u);
}

TEST(PanelCuts, AConeIsCutEvenWhereItIsNearlyFlat) {
	for (const double sine : {0.1, 0.5, 0.9, 0.99}) {
		const FlatPatterns patterns = flattened(ring(40, 12, frustum(sine)));
		EXPECT_EQ(patterns.pieces[0].cuts, 1) << sine;
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-10) << sine;
	}
}

TEST(PanelCuts, AWindowStaysOpenAndUncut) {
	const TriangleMesh flat = withHole(jitteredGrid(30, 30, flatSheet), {0.4, 0.55}, 0.2);
	TriangleMesh bent = flat; // rolled up
	for (auto p : bent.positions.colwise())
		p = Eigen::Vector3d(std::sin(p[0]), p[1], std::cos(p[0]));
	for (const TriangleMesh& mesh : {flat, withHole(flat, {0.8, 0.2}, 0.12)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_EQ(patterns.pieces[0].cuts, 0);
		EXPECT_GT(patterns.pieces[0].holes, 0);
		EXPECT_EQ(patterns.triangles.cols(), mesh.triangleCount()); // nothing filled
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
		EXPECT_TRUE(patterns.report.notes.empty());
	}
	// Rolled on a jittered grid it is only nearly developable.
	const FlatPatterns patterns = flattened(bent);
	EXPECT_EQ(patterns.pieces[0].cuts, 0);
	EXPECT_LT(patterns.report.meanEdgeStrain, 2e-4);
	EXPECT_EQ(patterns.report.flippedFaces, 0);
}

TEST(PanelCuts, PanelsWithSeveralHolesAreCutFromHoleToHole) {
	// A tube with a window: the tube's end needs a cut, the window none.
	const TriangleMesh mesh = without(
		ring(40, 30, tube), [](const Eigen::Vector3d& p) { return p[0] > 0.8 && p[2] > 1 && p[2] < 2; });
	const FlatPatterns patterns = flattened(mesh);
	EXPECT_EQ(patterns.pieces[0].holes, 2);
	EXPECT_EQ(patterns.pieces[0].cuts, 1);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-10);
}

} // namespace
} // namespace developable::test
