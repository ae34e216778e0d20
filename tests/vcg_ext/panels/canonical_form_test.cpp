// SPDX-License-Identifier: GPL-3.0-or-later
// The same form of every copy of a surface, to the last bit, and panels that go back to where they were.
#include "developable/panels/canonical_form.h"

#include "developable/panels/cut_into_panels.h"
#include "panel_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace developable::test {
namespace {

using detail::CanonicalForm;
using detail::GivenPatches;

Eigen::Matrix3d anyTurn() {
	return Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized().toRotationMatrix();
}

/// Turned, moved and another size, with vertices, triangles and their corners in another order.
TriangleMesh another(const TriangleMesh& mesh, unsigned seed) {
	std::mt19937 random(seed);
	const auto shuffled = [&](int count) {
		std::vector<int> order(count);
		std::iota(order.begin(), order.end(), 0);
		for (int i = count; i-- > 1;)
			std::swap(order[i], order[random() % (i + 1)]);
		return order;
	};
	const std::vector<int> place = shuffled(mesh.vertexCount()), order = shuffled(mesh.triangleCount());
	TriangleMesh result = mesh;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		result.positions.col(place[vertex]) =
			37.1 * (anyTurn() * mesh.positions.col(vertex)) + Eigen::Vector3d(3, -2, 50);
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const int first = static_cast<int>(random() % 3);
		for (int corner = 0; corner < 3; ++corner)
			result.triangles(corner, t) = place[mesh.triangles((corner + first) % 3, order[t])];
		result.triangleSelected[t] = mesh.triangleSelected[order[t]];
	}
	return result;
}

/// Nothing about it is symmetric.
TriangleMesh lump(int subdivisions = 2) {
	TriangleMesh mesh = sphere(1, subdivisions);
	for (auto point : mesh.positions.colwise()) {
		const Eigen::Vector3d p = point;
		point = Eigen::Vector3d(2 * p.x() + 0.3 * p.y() * p.z(), p.y() + 0.4 * p.x() * p.x(),
								1.4 * p.z() + 0.2 * p.y() * p.y());
	}
	return mesh;
}

void expectSameForm(const TriangleMesh& mesh) {
	const GivenPatches given = detail::separatePatches(mesh, {});
	const TriangleMesh form = CanonicalForm(given).patches().mesh;
	for (const unsigned seed : {1U, 2U, 3U}) {
		const GivenPatches otherGiven = detail::separatePatches(another(mesh, seed), {});
		const TriangleMesh other = CanonicalForm(otherGiven).patches().mesh;
		EXPECT_EQ(form.positions, other.positions);
		EXPECT_EQ(form.triangles, other.triangles);
		EXPECT_EQ(form.triangleSelected, other.triangleSelected);
	}
}

TEST(CanonicalForm, isTheSameForEveryCopy) {
	TriangleMesh mesh = lump();
	for (int t = 0; t < mesh.triangleCount(); t += 7)
		mesh.triangleSelected[t] = 1;
	expectSameForm(mesh);
}

TEST(CanonicalForm, isTheSameForEveryCopyWhereAxesAreNotUnique) {
	expectSameForm(sphere(1, 2));                  // no principal axes
	expectSameForm(octahedron());                  //
	expectSameForm(jitteredGrid(9, 9, steepBump)); // one
	expectSameForm(grid(9, 9, steepBump));         // one, and the same turned by a quarter
	expectSameForm(grid(12, 5, flatSheet));        // all, both ways along each
}

TEST(CanonicalForm, leavesDetailsThatAreTooFineAsTheyAre) {
	TriangleMesh mesh = octahedron();
	const TriangleMesh small = mesh;
	const int count = mesh.vertexCount();
	mesh.positions.conservativeResize(3, 2 * count);
	mesh.positions.rightCols(count) = 1e-15 * small.positions;
	mesh.triangles.conservativeResize(3, 2 * small.triangleCount());
	mesh.triangles.rightCols(small.triangleCount()) = (small.triangles.array() + count).matrix();
	mesh = makeMesh(mesh.positions, mesh.triangles);
	const GivenPatches given = detail::separatePatches(mesh, {});
	EXPECT_EQ(CanonicalForm(given).patches().mesh.positions, given.mesh.positions);
}

TEST(CanonicalForm, carriesPanelsBackToTheirTriangles) {
	const TriangleMesh mesh = another(lump(), 5);
	const GivenPatches given = detail::separatePatches(mesh, {});
	const CanonicalForm form(given);
	const TriangleMesh& formMesh = form.patches().mesh;
	detail::PlannedSurface planned{formMesh, form.patches().origins,
								   withPanels(formMesh, strips(formMesh, 3))};
	int dart = 0;
	while (planned.surface.isCut(dart))
		++dart;
	planned.surface.setCut(dart, true);
	const detail::PlannedSurface back = form.carriedBack(planned);
	EXPECT_EQ(back.mesh.positions, given.mesh.positions);
	EXPECT_EQ(back.mesh.triangles, given.mesh.triangles);
	EXPECT_EQ(back.mesh.face, given.mesh.face);
	std::set<std::vector<int>> expected;
	for (std::vector<int> panel : panelsOf(planned.surface)) {
		for (int& t : panel)
			t = form.trianglesGiven()[t];
		std::sort(panel.begin(), panel.end());
		expected.insert(panel);
	}
	EXPECT_EQ(panelsOf(back.surface), expected);
	EXPECT_NEAR(form.inGiven(detail::seamLength(planned.surface)), detail::seamLength(back.surface), 1e-4);
}

/// "The same number of panels and seams within 1 % under rotation, scale and vertex order."
TEST(CutIntoPanels, findsTheSamePanelsInEveryCopy) {
	for (const TriangleMesh& mesh : {lump(1), sphere(1, 1)}) {
		const CutReport report = cutIntoPanels(mesh, {}, {}).report;
		for (const unsigned seed : {1U, 2U}) {
			const CutReport other = cutIntoPanels(another(mesh, seed), {}, {}).report;
			EXPECT_EQ(other.status, report.status);
			EXPECT_EQ(other.panels.size(), report.panels.size());
			EXPECT_EQ(other.darts, report.darts);
			EXPECT_NEAR(other.seamLength, 37.1 * report.seamLength, 1e-4 * other.seamLength);
		}
	}
}

} // namespace
} // namespace developable::test
