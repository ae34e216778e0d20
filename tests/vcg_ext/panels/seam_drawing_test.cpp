// SPDX-License-Identifier: GPL-3.0-or-later
// Seams that become smooth are shorter, less so where that is asked for.
#include "developable/panels/seam_drawing.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::PlannedSurface;
using detail::SeamDrawing;

/// A sheet in two panels with a wave between them.
PlannedSurface sheetWithWave(std::vector<int>& labels) {
	const TriangleMesh mesh =
		jitteredGrid(31, 31, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	labels =
		labelsOf(mesh, [](const Eigen::Vector3d& at) { return at[0] > 0.5 + 0.05 * std::sin(40 * at[1]); });
	std::vector<VertexOrigin> origins;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		origins.push_back({vertex, vertex, 0});
	return {mesh, origins, withPanels(mesh, labels)};
}

double area(const CutSurface& surface) {
	return surface.areas().sum();
}

TEST(SeamDrawing, isSmootherWhereItMayBe) {
	std::vector<int> labels;
	const PlannedSurface planned = sheetWithWave(labels);
	std::vector<Eigen::Vector3d> tips;
	SeamDrawing drawing(planned, labels, tips, {}, detail::sharpFeatures(planned.surface, 40));
	const PlannedSurface safe = drawing.drawn();
	drawing.draw(SeamDrawing::Manner::Taut);
	const PlannedSurface taut = drawing.drawn();
	drawing.draw(SeamDrawing::Manner::Smooth);
	const PlannedSurface smooth = drawing.drawn();
	EXPECT_LT(seamLength(safe.surface), seamLength(planned.surface));
	EXPECT_LT(seamLength(taut.surface), 0.97 * seamLength(safe.surface));
	EXPECT_LT(seamLength(smooth.surface), 0.97 * seamLength(safe.surface));
	for (const PlannedSurface* drawn : {&safe, &taut, &smooth}) {
		EXPECT_EQ(drawn->surface.usedPanelCount(), 2);
		EXPECT_NEAR(area(drawn->surface), 1, 1e-12);
	}

	ASSERT_TRUE(drawing.tightenAt({{0.5, 0.5, 0}}));
	const PlannedSurface between = drawing.drawn();
	EXPECT_LT(seamLength(between.surface), seamLength(safe.surface));
	EXPECT_GT(seamLength(between.surface), seamLength(smooth.surface));
	while (drawing.tightenAt({{0.5, 0.5, 0}}))
		continue;
	EXPECT_DOUBLE_EQ(seamLength(drawing.drawn().surface), seamLength(safe.surface));
}

TEST(SeamDrawing, drawsDartsThatAreKnownByTheirTips) {
	std::vector<int> labels;
	const PlannedSurface planned = sheetWithWave(labels);
	std::vector<Eigen::Vector3d> tips;
	const SeamDrawing drawing(planned, labels, tips, {}, detail::sharpFeatures(planned.surface, 40));
	tips.emplace_back(0.2, 0.5, 0); // as of darts that were added after seams were drawn first
	const PlannedSurface drawn = drawing.drawn();
	int darts = 0;
	for (const detail::SeamChain& chain : detail::seamChains(drawn.surface))
		darts += chain.isDart();
	EXPECT_EQ(darts, 1);
	EXPECT_EQ(drawn.surface.usedPanelCount(), 2);
}

} // namespace
} // namespace developable::test
