// SPDX-License-Identifier: GPL-3.0-or-later
// Parts are what they would be alone, and one result says all of them.
#include "developable/panels/given_parts.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace developable::test {
namespace {

using detail::GivenPatches;

TriangleMesh movedBy(TriangleMesh mesh, const Eigen::Vector3d& shift) {
	mesh.positions.colwise() += shift;
	return mesh;
}

const Eigen::Vector3d aside(5, 0, 0);

double dome(double u, double v) {
	return std::sqrt(std::max(0.0, 2 - u * u - v * v));
}

TriangleMesh domeOf(int side) {
	return grid(side, side, [](double u, double v) { return Eigen::Vector3d(u, v, dome(u - 0.5, v - 0.5)); });
}

std::vector<GivenPatches> partsOf(const TriangleMesh& mesh) {
	return detail::partsOf(detail::separatePatches(mesh, {}));
}

TEST(GivenParts, areAsIfGivenAlone) {
	const TriangleMesh first = octahedron(), second = movedBy(domeOf(5), aside);
	TriangleMesh both = together(first, second);
	both.singlePrecision = true;
	const std::vector<GivenPatches> parts = partsOf(both);
	ASSERT_EQ(parts.size(), 2u);
	EXPECT_TRUE(parts[0].mesh.singlePrecision && parts[1].mesh.singlePrecision);
	const GivenPatches alone = detail::separatePatches(second, {});
	EXPECT_EQ(parts[1].mesh.positions, alone.mesh.positions);
	EXPECT_EQ(parts[1].mesh.triangles, alone.mesh.triangles);
	for (std::size_t v = 0; v < alone.origins.size(); ++v)
		EXPECT_EQ(parts[1].origins[v].first, alone.origins[v].first + first.vertexCount());
	for (int t = 0; t < second.triangleCount(); ++t)
		EXPECT_EQ(parts[1].mesh.face[t], alone.mesh.face[t] + first.triangleCount());
	EXPECT_EQ(parts[1].vertexTaken.size(), std::size_t(both.vertexCount()));
	EXPECT_EQ(partsOf(first).size(), 1u);
}

/// One vertex in common is enough; what is only near is none.
TEST(GivenParts, areWhatSharesVerticesOrIsSewnTogether) {
	const TriangleMesh flat = grid(3, 3, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	EXPECT_EQ(partsOf(together(flat, movedBy(flat, {1, 1, 0}))).size(), 1u); // at a corner
	EXPECT_EQ(partsOf(together(flat, movedBy(flat, {1.001, 0, 0}))).size(), 2u);
	PatchOptions sewn;
	sewn.weldDistance = 0.01;
	const GivenPatches given = detail::separatePatches(together(flat, movedBy(flat, {1.001, 0, 0})), sewn);
	ASSERT_EQ(detail::partsOf(given).size(), 1u);
}

TEST(GivenParts, haveTheSeamsBetweenTheirOwnPatches) {
	const TriangleMesh flat = grid(3, 3, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	TriangleMesh twoPatches = together(flat, movedBy(flat, {1, 0, 0})); // of vertices of their own
	EXPECT_EQ(detail::separatePatches(twoPatches, {}).seamLength, 0); // not on the same vertices of the mesh
	for (int corner = 0; corner < 3 * twoPatches.triangleCount(); ++corner) {
		int& vertex = twoPatches.triangles.data()[corner];
		for (int other = 0; other < vertex; ++other)
			if (twoPatches.positions.col(other) == twoPatches.positions.col(vertex))
				vertex = other;
	}
	for (int t = flat.triangleCount(); t < twoPatches.triangleCount(); ++t) // a patch for each way round
		std::swap(twoPatches.triangles(1, t), twoPatches.triangles(2, t));
	const std::vector<GivenPatches> parts = partsOf(together(octahedron(), movedBy(twoPatches, aside)));
	ASSERT_EQ(parts.size(), 2u);
	EXPECT_EQ(parts[0].seamLength, 0);
	EXPECT_EQ(parts[1].seamLength, detail::separatePatches(movedBy(twoPatches, aside), {}).seamLength);
}

TEST(CutIntoPanels, cutsEveryPartAsIfItWereAlone) {
	const TriangleMesh first = domeOf(9);
	const TriangleMesh second = [&] {
		TriangleMesh larger = movedBy(first, aside);
		larger.positions *= 2;
		return larger;
	}();
	const CutResult a = cutIntoPanels(first, {}, {}), b = cutIntoPanels(second, {}, {});
	const CutResult both = cutIntoPanels(together(first, second), {}, {});
	ASSERT_EQ(both.report.panels.size(), a.report.panels.size() + b.report.panels.size());
	EXPECT_EQ(both.report.status, Status::Converged);
	EXPECT_EQ(both.report.seamLength, a.report.seamLength + b.report.seamLength);
	EXPECT_EQ(both.report.darts, a.report.darts + b.report.darts);
	EXPECT_EQ(both.report.smallestPanelArea, a.report.smallestPanelArea);
	EXPECT_EQ(both.report.maxDisplacement, std::max(a.report.maxDisplacement, b.report.maxDisplacement));
	EXPECT_GT(both.report.meanDisplacement, a.report.meanDisplacement);
	EXPECT_LT(both.report.meanDisplacement, b.report.meanDisplacement);
	const int panelsOfFirst = static_cast<int>(a.report.panels.size());
	for (std::size_t panel = 0; panel < both.report.panels.size(); ++panel) {
		const CutPanel& own = both.report.panels[panel];
		EXPECT_EQ(std::count(both.mesh.panel.begin(), both.mesh.panel.end(), int(panel)), own.triangles);
		EXPECT_EQ(own.neighbour < panelsOfFirst, int(panel) < panelsOfFirst);
	}
	ASSERT_EQ(both.mesh.triangles.cols(), a.mesh.triangles.cols() + b.mesh.triangles.cols());
	const auto pointOf = [&](int vertex) -> Eigen::Vector3d {
		const VertexOrigin origin = both.mesh.originOf(vertex);
		const auto at = [&](int v) -> Eigen::Vector3d {
			return v < first.vertexCount() ? first.positions.col(v)
										   : second.positions.col(v - first.vertexCount());
		};
		return (1 - origin.share) * at(origin.first) + origin.share * at(origin.second);
	};
	for (int t = 0; t < both.mesh.triangles.cols(); ++t)
		for (int corner = 0; corner < 3; ++corner) // no triangle has vertices of the other part
			EXPECT_EQ(pointOf(both.mesh.triangles(corner, t))[0] > 2, t >= a.mesh.triangles.cols());
}

TEST(CutIntoPanels, saysOnWhichPartANoteIs) {
	CutOptions options;
	options.maxDisplacement = 0; // no panel but a triangle
	const TriangleMesh flat = grid(3, 3, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	options.keepSelected = true;
	TriangleMesh held = together(flat, movedBy(domeOf(4), aside));
	held.triangleSelected.assign(held.triangleCount(), 1);
	const CutReport kept = cutIntoPanels(held, {}, options).report;
	EXPECT_EQ(kept.status, Status::NeedsCut);
	ASSERT_EQ(kept.notes.size(), 1u);
	EXPECT_EQ(kept.notes[0].find("Part 2 of 2, 18 faces round ("), 0u) << kept.notes[0];
}

TEST(CutIntoPanels, stopsAllParts) {
	const CutResult stopped = cutIntoPanels(together(sphere(1, 1), movedBy(sphere(1, 1), aside)), {}, {},
											[](double, const std::string&) { return false; });
	EXPECT_EQ(stopped.report.status, Status::Stopped);
	EXPECT_TRUE(stopped.report.panels.empty());
	EXPECT_EQ(stopped.mesh.triangles.cols(), 0);
}

} // namespace
} // namespace developable::test
