// SPDX-License-Identifier: GPL-3.0-or-later
// Panels of a surface with few triangles on the same one with many.
#include "developable/panels/thinned_patches.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CarriedPanels;
using detail::CutSurface;
using detail::GivenPatches;
using detail::PlannedSurface;
using detail::ThinnedPatches;

int dartsOf(const CutSurface& surface) {
	int darts = 0;
	for (const detail::SeamChain& chain : detail::seamChains(surface))
		darts += chain.isDart();
	return darts;
}

PlannedSurface plannedOn(const GivenPatches& patches, const std::vector<int>& labels) {
	return {patches.mesh, patches.origins, withPanels(patches.mesh, labels)};
}

class ThinnedPatchesTest : public testing::Test {
protected:
	const GivenPatches given = detail::separatePatches(jitteredGrid(61, 61, steepBump), {});
	const ThinnedPatches thinned{given, 400};
};

TEST_F(ThinnedPatchesTest, haveFewTrianglesOfTheSameShape) {
	const TriangleMesh& mesh = thinned.patches().mesh;
	EXPECT_LT(mesh.triangleCount(), given.mesh.triangleCount() / 6);
	EXPECT_GT(mesh.triangleCount(), 500);
	EXPECT_NEAR(boxDiagonal(mesh.positions), boxDiagonal(given.mesh.positions), 0.01);
	const Eigen::VectorXd distances =
		distancesToSurface(given.mesh.positions, mesh.positions, mesh.triangles);
	EXPECT_LT(distances.maxCoeff(), 0.02);
	EXPECT_EQ(detail::separatePatches(mesh, {}).mesh.triangleCount(), mesh.triangleCount());
}

TEST_F(ThinnedPatchesTest, getTheSamePanelsAsTheGivenOnes) {
	const PlannedSurface planned = plannedOn(thinned.patches(), strips(thinned.patches().mesh, 3));
	const CarriedPanels carried = thinned.carriedBack(planned, {});
	const CutSurface& surface = carried.planned.surface;
	EXPECT_EQ(surface.usedPanelCount(), 3);
	EXPECT_EQ(carried.planned.mesh.triangles, given.mesh.triangles);
	EXPECT_NEAR(detail::seamLength(surface), detail::seamLength(planned.surface),
				0.3 * detail::seamLength(planned.surface)); // along other edges
	for (int h = 0; h < 3 * given.mesh.triangleCount(); ++h)
		if (surface.isCut(h)) {
			EXPECT_NE(carried.clusters[triangleOf(h)],
					  carried.clusters[triangleOf(surface.assembly().across(h))]);
		}
}

/// Of the two halves, joined along a share of the line between them, that is left as a dart.
TEST_F(ThinnedPatchesTest, keepTheirDarts) {
	PlannedSurface planned = plannedOn(thinned.patches(), strips(thinned.patches().mesh, 2));
	std::vector<int> open;
	double cut = 0;
	for (const detail::SeamChain& chain : detail::seamChains(planned.surface))
		for (const int h : chain.halfEdges)
			if (planned.surface.middleOf(h)[1] > 0)
				open.push_back(h);
			else
				cut += planned.surface.length(h);
	planned.surface.join(open);
	ASSERT_EQ(dartsOf(planned.surface), 1);
	const CutSurface surface = thinned.carriedBack(planned, {}).planned.surface;
	EXPECT_EQ(surface.usedPanelCount(), 1);
	EXPECT_EQ(dartsOf(surface), 1);
	EXPECT_NEAR(detail::seamLength(surface), cut, 0.35 * cut);
	EXPECT_EQ(detail::eulerCharacteristic(surface, surface.panelOf(0)), 1);
}

/// Two sheets so near each other that triangles of one are nearest to the other.
TEST(ThinnedPatches, keepPatchesApart) {
	TriangleMesh above = jitteredGrid(31, 31, flatSheet);
	const TriangleMesh below = jitteredGrid(31, 31, flatSheet);
	above.positions.row(2).array() += 1e-9;
	const GivenPatches given = detail::separatePatches(together(above, below), {});
	const ThinnedPatches thinned(given, 300);
	EXPECT_EQ(thinned.limits({1, 2}), std::vector<double>({1, 2}));
	const TriangleMesh& mesh = thinned.patches().mesh;
	const std::vector<int> halves = strips(mesh, 2);
	const CarriedPanels carried = thinned.carriedBack(plannedOn(thinned.patches(), halves), {});
	EXPECT_EQ(carried.planned.surface.usedPanelCount(), 4);
	for (int t = 0; t < given.mesh.triangleCount(); ++t) {
		const double x = carried.planned.surface.barycentre(t)[0];
		if (std::abs(x - 0.5) > 0.1) {
			EXPECT_EQ(carried.planned.surface.panelOf(t) == carried.planned.surface.panelOf(0),
					  x < 0.5 && t < above.triangleCount());
		}
	}
}

TEST(ThinnedPatches, keepSelectedTrianglesWhole) {
	TriangleMesh mesh = jitteredGrid(61, 61, flatSheet);
	const std::vector<int> inside = labelsOf(mesh, [](const Eigen::Vector3d& at) {
		return std::abs(at[0] - 0.5) < 0.2 && std::abs(at[1] - 0.5) < 0.2;
	});
	mesh.triangleSelected.assign(inside.begin(), inside.end());
	const GivenPatches given = detail::separatePatches(mesh, {});
	const ThinnedPatches thinned(given, 400);
	const TriangleMesh& thin = thinned.patches().mesh;
	const std::vector<int> thinInside = labelsOf(thin, [](const Eigen::Vector3d& at) {
		return std::abs(at[0] - 0.5) < 0.15 && std::abs(at[1] - 0.5) < 0.15;
	});
	for (int t = 0; t < thin.triangleCount(); ++t)
		EXPECT_TRUE(!thinInside[t] || thin.triangleSelected[t]) << t;
	CutOptions options;
	options.keepSelected = true;
	const CarriedPanels carried = thinned.carriedBack(plannedOn(thinned.patches(), strips(thin, 2)), options);
	std::set<int> panels;
	for (int t = 0; t < given.mesh.triangleCount(); ++t)
		if (given.mesh.triangleSelected[t])
			panels.insert(carried.planned.surface.panelOf(t));
	EXPECT_EQ(panels.size(), 1u);
	EXPECT_EQ(carried.planned.surface.usedPanelCount(), 2);
}

} // namespace
} // namespace developable::test
