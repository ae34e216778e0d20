// SPDX-License-Identifier: GPL-3.0-or-later
// Panels of a surface without noise on the same one with it.
#include "developable/panels/smoothed_patches.h"

#include "developable/panels/found_panels.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::GivenPatches;
using detail::PlannedSurface;
using detail::SmoothedPatches;

std::vector<double> limitsOf(const GivenPatches& given) {
	return {0.02 * boxDiagonal(given.mesh.positions)};
}

class SmoothedPatchesTest : public testing::Test {
protected:
	const GivenPatches given = detail::separatePatches(noisy(jitteredGrid(31, 31, saddle), 0.1), {});
	const SmoothedPatches smoothed{given, limitsOf(given)};
};

TEST_F(SmoothedPatchesTest, haveTheSameTrianglesAndLessRoom) {
	ASSERT_TRUE(smoothed.hadDetail());
	EXPECT_EQ(smoothed.patches().mesh.triangles, given.mesh.triangles);
	EXPECT_NE(smoothed.patches().mesh.positions, given.mesh.positions);
	EXPECT_LT(smoothed.limits().front(), limitsOf(given).front());
	EXPECT_GT(smoothed.limits().front(), 0.6 * limitsOf(given).front());
}

/// Two halves of which one has a point on an edge, and a dart.
TEST_F(SmoothedPatchesTest, arePointForPointWhatWasGivenOnceCarriedBack) {
	TriangleMesh mesh = smoothed.patches().mesh;
	std::vector<VertexOrigin> origins = smoothed.patches().origins;
	const int a = mesh.triangles(0, 0), b = mesh.triangles(1, 0);
	origins.push_back({a, b, 0.25});
	mesh.positions.conservativeResize(3, mesh.vertexCount() + 1);
	mesh.positions.rightCols<1>() = pointAt(origins.back(), smoothed.patches().mesh.positions);
	PlannedSurface planned{mesh, origins, withPanels(mesh, strips(mesh, 2))};
	std::vector<int> open;
	for (const detail::SeamChain& chain : detail::seamChains(planned.surface))
		for (const int h : chain.halfEdges)
			if (planned.surface.middleOf(h)[1] > 0)
				open.push_back(h);
	planned.surface.join(open);
	const PlannedSurface back = smoothed.carriedBack(planned);
	EXPECT_EQ(back.mesh.positions.leftCols(given.mesh.vertexCount()), given.mesh.positions);
	EXPECT_EQ(back.mesh.positions.rightCols<1>(),
			  0.75 * given.mesh.positions.col(a) + 0.25 * given.mesh.positions.col(b));
	EXPECT_EQ(back.mesh.face, given.mesh.face);
	EXPECT_EQ(panelsOf(back.surface), panelsOf(planned.surface));
	for (int h = 0; h < 3 * mesh.triangleCount(); ++h)
		EXPECT_EQ(back.surface.isCut(h), planned.surface.isCut(h)) << h;
}

TEST(SmoothedPatches, areNoneOfASmoothSurface) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(31, 31, saddle), {});
	EXPECT_FALSE(SmoothedPatches(given, limitsOf(given)).hadDetail());
}

/// Found where there is no noise, they hold where it is.
TEST(SmoothedPatches, areWherePanelsAreLookedFor) {
	const TriangleMesh mesh = noisy(jitteredGrid(15, 15, steepBump), 0.1);
	const GivenPatches given = detail::separatePatches(mesh, {});
	ASSERT_TRUE(SmoothedPatches(given, limitsOf(given)).hadDetail());
	const detail::FoundPanels found = detail::findPanels({given, limitsOf(given), {}}, {});
	EXPECT_TRUE(found.hold);
	const PlannedSurface& best = found.planned.front();
	EXPECT_LE(best.surface.usedPanelCount(), 4);
	for (int vertex = 0; vertex < best.mesh.vertexCount(); ++vertex)
		EXPECT_EQ(best.mesh.positions.col(vertex), pointAt(best.origins[vertex], mesh.positions));
}

} // namespace
} // namespace developable::test
