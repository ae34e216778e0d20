// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces made of flat and bent pieces are cut along their creases, and nothing moves.
#include "developable/panels/crease_regions.h"
#include "developable/panels/cut_into_panels.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <set>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::SharpFeatures;

/// What a lathe makes: rings of vertices with given radii and heights, closed by the first and last.
TriangleMesh turned(const std::vector<std::array<double, 2>>& profile, int sides) {
	const int rings = static_cast<int>(profile.size());
	const auto at = [&](int ring, int side) { return (ring % rings) * sides + side % sides; };
	Positions positions(3, rings * sides);
	Eigen::Matrix3Xi triangles(3, 2 * rings * sides);
	for (int ring = 0; ring < rings; ++ring)
		for (int side = 0; side < sides; ++side) {
			const double angle = 2 * pi * side / sides;
			const auto [radius, height] = profile[ring];
			positions.col(at(ring, side)) << radius * std::cos(angle), radius * std::sin(angle), height;
			const int a = at(ring, side), b = at(ring, side + 1);
			const int c = at(ring + 1, side), d = at(ring + 1, side + 1);
			triangles.col(2 * a) << a, b, c;
			triangles.col(2 * a + 1) << b, d, c;
		}
	return makeMesh(positions, triangles);
}

/// A washer with a collar: six rings of faces, of which each is flat or a tube.
TriangleMesh collar() {
	return turned({{1, 0}, {3, 0}, {3, 0.3}, {2, 0.3}, {2, 1.5}, {1, 1.5}}, 36);
}

TEST(StillPanels, areTheFacesOfWhatALatheMakes) {
	const CutReport report = cutIntoPanels(collar(), {}, {}).report;
	EXPECT_EQ(report.status, Status::Converged);
	EXPECT_EQ(report.panels.size(), 6U);
	EXPECT_LT(report.maxDisplacement, 1e-9);
	const double facet = 2 * std::sin(pi / 36); // of a circle of radius 1: its chord
	double seams = 0;
	for (const double radius : {1.0, 3.0, 3.0, 2.0, 2.0, 1.0})
		seams += 36 * radius * facet;
	seams += 0.3 + 1.2 + 1.5; // slits of the tubes
	EXPECT_NEAR(report.seamLength, seams, 1e-9);
}

/// A quarter of a flat ring, and a rim along its outer border.
TriangleMesh quarterRing(double rimHeight) {
	return grid(37, 3, [&](double u, double v) {
		const double angle = pi / 2 * u, radius = v > 0.25 ? 3 : 2;
		return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), v > 0.75 ? rimHeight : 0);
	});
}

TEST(StillPanels, sayWhyTheirSeamsAreThere) {
	for (const CutPanel& panel : cutIntoPanels(collar(), {}, {}).report.panels)
		EXPECT_EQ(panel.reason, Reason::SeamTooFar);
	const CutReport report = cutIntoPanels(quarterRing(0.05), {}, {}).report;
	EXPECT_EQ(report.panels.size(), 2U);
	EXPECT_EQ(report.maxDisplacement, 0);
	for (const CutPanel& panel : report.panels) // a rim as low as that could be bent into the plane
		EXPECT_EQ(panel.reason, Reason::SeamStill);
	for (const CutPanel& panel : cutIntoPanels(quarterRing(0.5), {}, {}).report.panels)
		EXPECT_EQ(panel.reason, Reason::SeamTooFar);
}

TEST(StillPanels, areOneWhereAWholePanelIsFolded) {
	const TriangleMesh folded = grid(9, 9, [](double u, double v) {
		return Eigen::Vector3d(u, v, std::abs(u - 0.5)); // by a right angle
	});
	const CutReport report = cutIntoPanels(folded, {}, {}).report;
	EXPECT_EQ(report.status, Status::NothingToDo);
	EXPECT_EQ(report.panels.size(), 1U);
}

TEST(StillPanels, areNoneOfARoundShape) {
	const CutReport report = cutIntoPanels(sphere(1, 2), {}, {}).report; // of 320 triangles
	EXPECT_EQ(report.status, Status::Converged);
	EXPECT_GT(report.meanDisplacement, 1e-3);
}

/// Its rings are parts of cones, which turn by 11° from one to the next: no creases.
TEST(StillPanels, areNotTheRingsOfABend) {
	const TriangleMesh bend = grid(13, 9, [](double u, double v) {
		const double round = 1.5 * pi * u, along = pi / 2 * v, radius = 3 + std::cos(round);
		return Eigen::Vector3d(radius * std::cos(along), radius * std::sin(along), std::sin(round));
	});
	const CutReport report = cutIntoPanels(bend, {}, {}).report;
	EXPECT_EQ(report.status, Status::Converged);
	EXPECT_LT(report.panels.size(), 6U); // of eight rings
	EXPECT_GT(report.meanDisplacement, 1e-3);
}

TEST(StillPanels, mirrorEachOtherIfTheyAreTo) {
	CutOptions options;
	options.symmetric = true;
	const CutResult cut = cutIntoPanels(collar(), {}, options);
	EXPECT_EQ(cut.report.status, Status::Converged);
	EXPECT_LT(cut.report.maxDisplacement, 1e-9);
	EXPECT_EQ(cut.report.panels.size(), 6U); // each of which is its own mirror image
	EXPECT_TRUE(cut.report.notes.empty());
}

TEST(CreaseRegions, areWhatCreasesEnclose) {
	const CutSurface surface(assembled(collar()));
	const SharpFeatures features = detail::sharpFeatures(surface, 40);
	std::vector<int> all(surface.assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	const std::vector<int> labels = detail::regionsBetween(features, surface, all);
	EXPECT_EQ(std::set<int>(labels.begin(), labels.end()).size(), 6U);
	for (std::size_t t = 0; t < labels.size(); t += 2)
		EXPECT_EQ(labels[t], labels[t + 1]);
}

TEST(CreaseRegions, areDevelopableUnlessTheyAreCurved) {
	CutSurface surface(assembled(collar()));
	EXPECT_FALSE(detail::isDevelopable(surface)); // with its edges inside
	std::vector<int> all(surface.assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	surface.relabel(detail::regionsBetween(detail::sharpFeatures(surface, 40), surface, all));
	EXPECT_TRUE(detail::isDevelopable(surface));
	EXPECT_FALSE(detail::isDevelopable(CutSurface(assembled(sphere(1, 2)))));
}

} // namespace
} // namespace developable::test
