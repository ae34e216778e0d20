// SPDX-License-Identifier: GPL-3.0-or-later
// Jagged seams and darts become straight, where they may.
#include "developable/panels/taut_curves.h"

#include "developable/panels/relief_darts.h"
#include "developable/panels/seam_chains.h"
#include "panel_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::DrawnSeams;
using detail::PlannedSurface;
using detail::SharpFeatures;
using detail::TautLimits;

/// A mesh in panels whose seams run along edges.
struct Jagged {
	Jagged(const TriangleMesh& on, const std::vector<int>& labels)
		: mesh(on), planned{mesh, originsOf(mesh), withPanels(mesh, strips(mesh, 1))},
		  drawn{{mesh, originsOf(mesh), labels}, withPanels(mesh, labels)} {}

	static std::vector<VertexOrigin> originsOf(const TriangleMesh& mesh) {
		std::vector<VertexOrigin> origins;
		for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
			origins.push_back({vertex, vertex, 0});
		return origins;
	}

	DrawnSeams taut(TautLimits limits = {}) const {
		limits.stays.resize(mesh.triangleCount(), 0);
		return pulledTaut(drawn, planned, detail::sharpFeatures(planned.surface, 40), limits);
	}

	TriangleMesh mesh;
	PlannedSurface planned;
	DrawnSeams drawn;
};

TriangleMesh sheet() {
	return jitteredGrid(31, 31, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
}

Jagged halves(const TriangleMesh& mesh) {
	return {mesh, labelsOf(mesh, [](const Eigen::Vector3d& at) { return at[0] > 0.51; })};
}

std::vector<double> areasOf(const CutSurface& surface) {
	std::vector<double> areas;
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (!surface.trianglesOf(panel).empty())
			areas.push_back(surface.area(panel));
	std::sort(areas.begin(), areas.end());
	return areas;
}

TEST(PulledTaut, aJaggedSeamIsStraight) {
	const Jagged jagged = halves(sheet());
	const DrawnSeams taut = jagged.taut();
	EXPECT_GT(seamLength(jagged.drawn.surface), 1.15);
	EXPECT_LT(seamLength(taut.surface), 1.02);
	EXPECT_EQ(taut.surface.usedPanelCount(), 2);
	EXPECT_NEAR(taut.surface.areas().sum(), 1, 1e-12);
	const std::vector<double> before = areasOf(jagged.drawn.surface), after = areasOf(taut.surface);
	EXPECT_NEAR(after[0], before[0], 0.02);
}

TEST(PulledTaut, whatStaysStays) {
	const Jagged jagged = halves(sheet());
	TautLimits limits;
	limits.stays.assign(jagged.mesh.triangleCount(), 1);
	EXPECT_DOUBLE_EQ(seamLength(jagged.taut(limits).surface), seamLength(jagged.drawn.surface));
	for (int t = 0; t < jagged.mesh.triangleCount(); ++t)
		limits.stays[t] = jagged.planned.surface.barycentre(t)[1] > 0.5;
	const double half = seamLength(jagged.taut(limits).surface);
	EXPECT_LT(half, seamLength(jagged.drawn.surface) - 0.05);
	EXPECT_GT(half, seamLength(jagged.taut().surface) + 0.05);
}

TEST(PulledTaut, heldTrianglesAreNotSplit) {
	const Jagged jagged = halves(sheet());
	TautLimits limits;
	for (int t = 0; t < jagged.mesh.triangleCount(); ++t)
		limits.held.push_back(jagged.drawn.surface.panelOf(t) == jagged.drawn.surface.panelOf(0));
	const DrawnSeams taut = jagged.taut(limits);
	EXPECT_LT(seamLength(taut.surface), seamLength(jagged.drawn.surface) - 0.05);
	std::vector<int> parts(jagged.mesh.triangleCount(), 0);
	for (const int t : taut.split.mesh.face)
		++parts[t];
	int split = 0;
	for (int t = 0; t < jagged.mesh.triangleCount(); ++t) {
		EXPECT_TRUE(!limits.held[t] || parts[t] == 1);
		split += parts[t] > 1;
	}
	EXPECT_GT(split, 5) << "of the others some are";
}

TEST(PulledTaut, aSeamOnACreaseStays) {
	const TriangleMesh roof =
		grid(21, 21, [](double u, double v) { return Eigen::Vector3d(u, v, -2 * std::abs(u - 0.5)); });
	const Jagged jagged(roof, labelsOf(roof, [](const Eigen::Vector3d& at) { return at[0] > 0.5; }));
	const DrawnSeams taut = jagged.taut();
	EXPECT_DOUBLE_EQ(seamLength(taut.surface), seamLength(jagged.drawn.surface));
	EXPECT_EQ(taut.split.mesh.vertexCount(), roof.vertexCount());
}

TEST(PulledTaut, dartsKeepTheirTips) {
	const TriangleMesh mesh = sheet();
	Jagged jagged(mesh, strips(mesh, 1));
	const detail::Dart dart = cutDart(jagged.drawn.surface, 0, {0.41, 0.63, 0}, 0, {});
	const DrawnSeams taut = jagged.taut();
	const std::vector<detail::SeamChain> chains = detail::seamChains(taut.surface);
	ASSERT_EQ(chains.size(), 1U);
	EXPECT_TRUE(chains[0].isDart());
	EXPECT_LT(chains[0].length, dart.length);
	const PatchAssembly& assembly = taut.surface.assembly();
	const int tip = chains[0].ends[chains[0].freeEnd[0] ? 0 : 1];
	EXPECT_EQ((assembly.originalPositions.col(assembly.placeOfCopy[tip]) - dart.tip).norm(), 0);
}

TEST(PulledTaut, threePanelsMeetAsBefore) {
	const TriangleMesh mesh = sheet();
	const Jagged jagged(mesh, labelsOf(mesh, [](const Eigen::Vector3d& at) {
							return at[1] < 0.45 ? 0 : at[0] > 0.55 ? 1 : 2;
						}));
	const DrawnSeams taut = jagged.taut();
	EXPECT_EQ(taut.surface.usedPanelCount(), 3);
	EXPECT_EQ(seamChains(taut.surface).size(), seamChains(jagged.drawn.surface).size());
	EXPECT_LT(seamLength(taut.surface), 0.9 * seamLength(jagged.drawn.surface));
	const std::vector<double> before = areasOf(jagged.drawn.surface), after = areasOf(taut.surface);
	for (std::size_t i = 0; i < before.size(); ++i)
		EXPECT_NEAR(after[i], before[i], 0.03);
}

TEST(PulledTaut, aRingStaysOne) {
	const TriangleMesh ball = sphere(1, 3);
	const Jagged jagged(ball, labelsOf(ball, [](const Eigen::Vector3d& at) { return at[2] > 0.1; }));
	const DrawnSeams taut = jagged.taut();
	EXPECT_EQ(taut.surface.usedPanelCount(), 2);
	EXPECT_LT(seamLength(taut.surface), seamLength(jagged.drawn.surface));
	EXPECT_GT(seamLength(taut.surface), 6) << "the circle itself has 6.25";
	EXPECT_LT(seamLength(taut.surface), 6.4);
}

} // namespace
} // namespace developable::test
