// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flat_start.h"
#include "developable/flatten/flip_free_newton.h"
#include "developable/flatten/panel_flattener.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// The layout of an uncut panel, in the order of the panel's vertices.
detail::PlanePositions inPanelOrder(const FlatPatterns& patterns, const detail::PanelMesh& panel) {
	detail::PlanePositions positions(2, panel.vertexCount());
	for (int corner = 0; corner < panel.halfEdgeCount(); ++corner)
		positions.col(panel.start(corner)) = patterns.positions.col(patterns.vertexAt(corner));
	return positions;
}

TEST(FlipFreeNewton, LowersTheEnergyOfTheConformalStart) {
	for (const Surface& surface : {sphereCap(1), Surface(saddle), Surface(bumpedCylinder)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(20, 20, surface));
		const detail::PanelMesh panel = onlyPanel(assembly);
		const detail::PlaneSprings springs(panel);
		const detail::PlanePositions start = detail::conformalStart(panel);
		const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
		EXPECT_LT(patterns.report.elasticEnergy, 0.5 * springs.energy(start));
		EXPECT_TRUE(patterns.pieces[0].converged);
	}
}

TEST(FlipFreeNewton, IsNextToTheLeastEnergyAndHasLessMeanStrain) {
	for (const Surface& surface : {sphereCap(1), Surface(saddle), Surface(bumpedCylinder)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(20, 20, surface));
		const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
		detail::FlatPanel least{onlyPanel(assembly), detail::conformalStart(onlyPanel(assembly)), {}, 0};
		detail::PlaneSprings springs(least.mesh);
		const double first = springs.energy(least.positions);
		EXPECT_TRUE(detail::FlipFreeNewton(springs, least.positions).minimize(400, {}).converged);
		// At a minimum no vertex is pulled anywhere.
		EXPECT_LT(springs.gradient(least.positions).norm(), 1e-5 * std::sqrt(first));
		EXPECT_GT(patterns.report.elasticEnergy, springs.energy(least.positions));
		EXPECT_LT(patterns.report.elasticEnergy, 1.005 * springs.energy(least.positions));
		EXPECT_LT(patterns.report.meanEdgeStrain, 0.985 * detail::edgeStrains(least).mean());
	}
}

TEST(FlipFreeNewton, TheCircleStartFlipsNothingAndLeadsToTheSameMinimum) {
	const PatchAssembly assembly = assembled(withHole(jitteredGrid(20, 20, bumpedCylinder), {0, 0.5}, 0.1));
	const detail::PanelMesh panel = onlyPanel(assembly);
	detail::PlanePositions x = detail::circleStart(panel, detail::boundaryLoops(panel));
	EXPECT_EQ(detail::countFlipped(panel.triangles, x), 0);
	detail::PlaneSprings springs(panel);
	EXPECT_TRUE(detail::FlipFreeNewton(springs, x).minimize(400, {}).converged);
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
	EXPECT_EQ(patterns.pieces[0].holes, 1);
	detail::PlanePositions other = inPanelOrder(patterns, panel);
	EXPECT_TRUE(detail::FlipFreeNewton(springs, other).minimize(400, {}).converged);
	EXPECT_NEAR(springs.energy(x), springs.energy(other), 1e-8 * springs.energy(x));
}

TEST(FlipFreeNewton, EndsWhereAPanelFoldsAndMoreStepsWouldGainLittle) {
	TriangleMesh mesh = sphere(1, 4);
	mesh.triangles = mesh.triangles.rightCols(mesh.triangleCount() - 16).eval();
	const detail::PanelMesh panel = onlyPanel(assembled(makeMesh(mesh.positions, mesh.triangles)));
	detail::PlanePositions x = detail::conformalStart(panel);
	detail::PlaneSprings springs(panel);
	const detail::FlatMinimum minimum = detail::FlipFreeNewton(springs, x).minimize(400, {});
	EXPECT_LT(minimum.iterations, 200);
	EXPECT_EQ(detail::countFlipped(panel.triangles, x), 0);
	const double energy = springs.energy(x);
	detail::FlipFreeNewton(springs, x).minimize(100, {});
	EXPECT_GT(springs.energy(x), 0.9 * energy);
}

} // namespace
} // namespace developable::test
