// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/flat_border.h"

#include "support/cone_ramp.h"
#include "support/finite_differences.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

using detail::BorderGap;
using detail::FlatBorder;

FlatBorder laidFlat(const PatchAssembly& assembly, const Positions& positions,
					const std::vector<int>& halfEdges) {
	return {assembly, positions, borderAngles(assembly, positions), halfEdges};
}

TEST(FlatBorder, GoesRoundEveryDiskEdgeByEdge) {
	const PatchAssembly assembly =
		assembled(together(jitteredGrid(9, 7, saddle), withTwoHoles(31, quarterCylinder)));
	const std::vector<std::vector<int>> borders = detail::bordersOfDisks(assembly);
	ASSERT_EQ(borders.size(), 2U);
	ASSERT_EQ(borders[0].size(), 2U * (8 + 6));
	for (std::size_t i = 0; i < borders[0].size(); ++i) {
		const int next = borders[0][(i + 1) % borders[0].size()];
		EXPECT_LT(assembly.across(borders[0][i]), 0);
		EXPECT_EQ(assembly.copyAt(nextCorner(borders[0][i])), assembly.copyAt(next));
	}
	EXPECT_TRUE(borders[1].empty());
	EXPECT_TRUE(detail::bordersOfDisks(assembled(sphere(1, 2)))[0].empty());
	TriangleMesh mixed = grid(4, 4, flatSheet);
	std::swap(mixed.triangles(0, 5), mixed.triangles(1, 5));
	EXPECT_TRUE(detail::bordersOfDisks(assembled(mixed))[0].empty());
}

TEST(FlatBorder, EnclosesWhatADevelopablePatchIsLarge) {
	for (const Surface& surface : {Surface(flatSheet), Surface(quarterCylinder), Surface(coneBand)}) {
		const PatchAssembly assembly = assembled(grid(21, 6, surface));
		const FlatBorder border =
			laidFlat(assembly, assembly.originalPositions, detail::bordersOfDisks(assembly)[0]);
		EXPECT_LT((border.points().back() - border.points().front()).norm(), 1e-12);
		double twice = 0; // to the left of it
		for (std::size_t i = 0; i + 1 < border.points().size(); ++i)
			twice += border.points()[i][0] * border.points()[i + 1][1] -
					 border.points()[i][1] * border.points()[i + 1][0];
		EXPECT_NEAR(twice / 2, copyAreas(assembly, assembly.originalPositions).sum(), 1e-12);
		EXPECT_TRUE(detail::crossingsOf(border.closed()).empty());
	}
}

TEST(FlatBorder, CrossesItselfWhereItGoesRoundByMoreThanATurn) {
	for (const double more : {-0.02, 0.02, 0.3}) {
		const PatchAssembly assembly = assembled(coneRamp(more, 0.05));
		const Eigen::Matrix2Xd border =
			laidFlat(assembly, assembly.originalPositions, detail::bordersOfDisks(assembly)[0]).closed();
		EXPECT_EQ(detail::crossingsOf(border).empty(), more < 0) << more;
		// All of the beginning but the drift, and what of the outer arc comes after it.
		const double covered = detail::longestCoveredStretch(border);
		if (more == 0.3)
			EXPECT_NEAR(covered, 0.45 + 0.3 * 1.5, 0.15);
		else
			EXPECT_LE(covered, more < 0 ? 0 : 0.5);
	}
}

/// From edge to point along the border, and from point to edge.
TEST(FlatBorder, HasGapsWithTheGradientThatDifferencesShow) {
	PatchAssembly assembly = assembled(jitteredGrid(8, 6, saddle));
	assembly.placeFixed[0] = 1;
	const std::vector<int> border = detail::bordersOfDisks(assembly)[0];
	const std::vector<int> way(border.begin() + 3, border.begin() + 14);
	for (const auto& [edge, point] : {std::pair(0, 11), std::pair(0, 5), std::pair(10, 0), std::pair(10, 1),
									  std::pair(4, 9), std::pair(6, 2)}) {
		const BorderGap gap = {way, edge, point};
		const auto width = [&](const Positions& positions) {
			return laidFlat(assembly, positions, way).gap(gap.edge, gap.point);
		};
		const Positions gradient = gapGradient(assembly, assembly.originalPositions, gap,
											   laidFlat(assembly, assembly.originalPositions, way));
		Positions expected = centralDifferences(width, assembly.originalPositions);
		for (int place = 0; place < assembly.placeCount(); ++place)
			if (assembly.placeFixed[place])
				expected.col(place).setZero();
		EXPECT_LT((gradient - expected).cwiseAbs().maxCoeff(), 1e-8) << edge << " " << point;
		EXPECT_GT(gradient.norm(), 0.1);
	}
}

} // namespace
} // namespace developable::test
