// SPDX-License-Identifier: GPL-3.0-or-later
// A ring becomes a disk by the shortest slit, and a disk stays as it is.
#include "developable/panels/ring_slits.h"

#include "developable/panels/first_panels.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace developable::test {
namespace {

using detail::CutSurface;

TEST(RingSlits, areAsLongAsATubeIs) {
	for (const int rows : {9, 2}) { // with one row of faces both ends of an edge are on the border
		const TriangleMesh mesh = tube(24, rows);
		CutSurface surface = withPanels(mesh, strips(mesh, 1));
		ASSERT_EQ(detail::eulerCharacteristic(surface, 0), 0);
		detail::slitHoles(surface, 0);
		EXPECT_EQ(detail::eulerCharacteristic(surface, 0), 1);
		EXPECT_EQ(surface.usedPanelCount(), 1);
		EXPECT_NEAR(seamLength(surface), 2, 1e-9);
	}
}

TEST(RingSlits, areAsManyAsHoles) {
	const TriangleMesh mesh = withTwoHoles(31, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	CutSurface surface = withPanels(mesh, strips(mesh, 1));
	ASSERT_EQ(detail::eulerCharacteristic(surface, 0), -1);
	detail::slitHoles(surface, 0, 0);
	EXPECT_EQ(detail::eulerCharacteristic(surface, 0), 0);
	detail::slitHoles(surface, 0);
	EXPECT_EQ(detail::eulerCharacteristic(surface, 0), 1);
	const double length = seamLength(surface);
	EXPECT_GT(length, 0);
	detail::slitHoles(surface, 0);
	EXPECT_EQ(seamLength(surface), length);
}

/// A sheet with a ramp on it: by its normals that is one half, and a ring the other.
TriangleMesh sheetWithRamp() {
	return jitteredGrid(41, 41, [](double u, double v) {
		const bool onRamp = std::max(std::abs(u - 0.5), std::abs(v - 0.5)) < 0.25;
		return Eigen::Vector3d(u, v, onRamp ? u - 0.25 : 0);
	});
}

TEST(RingSlits, areCutInHalvesThatAreRings) {
	const TriangleMesh mesh = sheetWithRamp();
	std::vector<VertexOrigin> origins;
	origins.reserve(mesh.vertexCount());
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		origins.push_back({vertex, vertex, 0});
	detail::PlannedSurface planned{mesh, origins, withPanels(mesh, strips(mesh, 1))};
	const std::vector<int> triangles = planned.surface.trianglesOf(0);
	ASSERT_TRUE(detail::divideInTwo(planned, {}, 0));
	detail::slitPanelsOf(planned.surface, triangles);
	ASSERT_GE(planned.surface.usedPanelCount(), 2);
	for (int panel = 0; panel < planned.surface.panelCount(); ++panel)
		EXPECT_EQ(detail::eulerCharacteristic(planned.surface, panel), 1);
	int slits = 0;
	for (const detail::SeamChain& chain : detail::seamChains(planned.surface))
		slits += chain.within();
	EXPECT_EQ(slits, 1);
}

} // namespace
} // namespace developable::test
