// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of panels that are sewn together stays within what is preferred, where that is easy.
#include "developable/panels/sewn_panels.h"

#include "developable/newton/constrained_newton.h"
#include "developable/panels/planned_surface.h"
#include "developable/panels/ring_slits.h"
#include "developable/panels/sewn_failures.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::GivenPatches;
using detail::PlannedSurface;
using detail::SewnPanels;

TEST(SewnPanels, moveNoFartherThanIsPreferredWhereThatIsEasy) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(25, 25, steepBump), {});
	const PlannedSurface planned{given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, 2))};
	const TriangleMesh cut = detail::meshAsCut(planned, given.vertexTaken);
	const double diagonal = boxDiagonal(given.mesh.positions);
	const auto sewn = [&](double preferredMove) {
		return detail::developSewnPanels(cut, planned.surface, {diagonal}, {}, preferredMove,
										 detail::SewnRun::Brief, {});
	};
	const double farthest = sewn(1).maxDisplacement;
	const double preferred = 0.97 * farthest;
	const SewnPanels within = sewn(preferred / diagonal);
	EXPECT_EQ(detail::worstOf(within), -1);
	EXPECT_LE(within.maxDisplacement, preferred);
	EXPECT_GT(within.maxDisplacement, preferred / 2);
}

/// It is developable, but no sheet.
TEST(SewnPanels, areNoneWhereTheyNeedACutToLieFlat) {
	const GivenPatches given = detail::separatePatches(tube(24, 9), {});
	PlannedSurface planned{given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, 1))};
	const auto sewn = [&] {
		return detail::developSewnPanels(detail::meshAsCut(planned, given.vertexTaken), planned.surface, {1},
										 {}, 1, detail::SewnRun::Whole, {});
	};
	const SewnPanels ring = sewn();
	EXPECT_EQ(detail::worstOf(ring), 0);
	EXPECT_EQ(ring.panels[0].reason, Reason::NeedsCut);
	detail::slitHoles(planned.surface, 0);
	EXPECT_EQ(detail::worstOf(sewn()), -1);
}

/// Over twice the unit square.
Eigen::Vector3d mirroredSaddle(double u, double v) {
	const double x = 2 * u;
	return {x, v, saddle(1 - std::abs(x - 1), v)[2]};
}

/// Little room is no reason to cut where the method by itself comes as close.
TEST(SewnPanels, holdWithinLessThanIsPreferredWhereTheMethodComesAsClose) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(49, 25, mirroredSaddle), {});
	const PlannedSurface planned{given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, 2))};
	const TriangleMesh cut = detail::meshAsCut(planned, given.vertexTaken);
	const double preferred = ConstrainedNewtonOptions().tuning.preferredMove;
	const double limit = 0.6 * preferred * boxDiagonal(given.mesh.positions);
	for (const detail::SewnRun run :
		 {detail::SewnRun::Brief, detail::SewnRun::OneWay, detail::SewnRun::Whole}) {
		const SewnPanels sewn =
			detail::developSewnPanels(cut, planned.surface, {limit}, {}, preferred, run, {});
		EXPECT_EQ(detail::worstOf(sewn), -1);
		EXPECT_EQ(sewn.provisional, run == detail::SewnRun::Brief);
	}
	ConstrainedNewtonOptions plain;
	plain.tuning.closerRounds = 0;
	const PatchAssembly assembly = assembled(cut);
	Positions positions = assembly.originalPositions;
	constrainedNewton(assembly, positions, plain);
	EXPECT_GT(displacementMap(assembly.originalPositions, positions).maxCoeff(), limit);
}

/// What a coarse level says is what the surface does, and takes less time.
TEST(SewnPanels, areSeenOnACoarseLevelOfALargeSurfaceIfBriefly) {
	const auto sewn = [&](int side, bool brief) {
		const GivenPatches given = detail::separatePatches(jitteredGrid(side, side, steepBump), {});
		const PlannedSurface planned{given.mesh, given.origins,
									 withPanels(given.mesh, strips(given.mesh, 3))};
		const TriangleMesh cut = detail::meshAsCut(planned, given.vertexTaken);
		const double diagonal = boxDiagonal(given.mesh.positions);
		return detail::developSewnPanels(cut, planned.surface, {diagonal}, {}, 1,
										 brief ? detail::SewnRun::Brief : detail::SewnRun::Whole, {});
	};
	EXPECT_FALSE(sewn(30, true).coarse);
	const SewnPanels coarse = sewn(48, true), whole = sewn(48, false);
	EXPECT_TRUE(coarse.coarse);
	EXPECT_LT(coarse.work, whole.work);
	EXPECT_FALSE(whole.coarse);
	EXPECT_EQ(detail::worstOf(coarse), -1);
	EXPECT_EQ(detail::worstOf(whole), -1);
	ASSERT_EQ(coarse.panels.size(), whole.panels.size());
	EXPECT_NEAR(coarse.maxDisplacement, whole.maxDisplacement, 0.2 * whole.maxDisplacement);
	for (std::size_t panel = 0; panel < whole.panels.size(); ++panel) {
		EXPECT_EQ(coarse.panels[panel].triangles, whole.panels[panel].triangles);
		EXPECT_NEAR(coarse.panels[panel].maxDisplacement, whole.panels[panel].maxDisplacement,
					0.3 * whole.maxDisplacement);
	}
}

/// Where one panel winds over itself when laid flat it does so on the surface's own triangles: these, and not
/// those of the coarse level, are what a notch is closed along.
TEST(SewnPanels, overlapsOfACoarseLevelAreOnTheSurface) {
	const TriangleMesh mesh = grid(280, 12, [](double u, double v) { // more than one turn of a flat ring
		const double angle = 2.2 * pi * u, radius = 4 + v;
		return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.5 * u + 0.02 * v * v);
	});
	const GivenPatches given = detail::separatePatches(mesh, {});
	const PlannedSurface planned{given.mesh, given.origins, withPanels(given.mesh, strips(given.mesh, 1))};
	const SewnPanels sewn =
		detail::developSewnPanels(detail::meshAsCut(planned, given.vertexTaken), planned.surface,
								  {0.02 * boxDiagonal(mesh.positions)}, {}, 1, detail::SewnRun::Brief, {});
	ASSERT_TRUE(sewn.coarse);
	ASSERT_EQ(sewn.overlaps.size(), 1u);
	EXPECT_TRUE(detail::overlaps(sewn.panels[0]));
	for (const Eigen::Vector3d& point : sewn.overlaps.at(0)) {
		double nearest = 1;
		for (int t = 0; t < mesh.triangleCount(); ++t)
			nearest = std::min(nearest, (barycentre(mesh.positions, mesh.triangles.col(t)) - point).norm());
		EXPECT_LT(nearest, 1e-9);
	}
}

/// Limits by default are of the smallest box, and what is preferred has to be the same however a surface is
/// turned: panels that hold end within the limit of any.
TEST(CutIntoPanels, keepsTheDefaultLimitOfTheSmallestBoxWhereverItLies) {
	TriangleMesh mesh = sphere(1, 2);
	for (auto point : mesh.positions.colwise()) // a rounded box, whose slanted boxes are much larger
		point /= std::pow(point.cwiseAbs().maxCoeff(), 0.7);
	mesh.positions.row(0) *= 1.5;
	const double diagonal = boxDiagonal(mesh.positions);
	const CutReport straight = cutIntoPanels(mesh, {}, {}).report;
	mesh.positions = Eigen::Quaterniond(0.8, 0.2, -0.4, 0.4).normalized().toRotationMatrix() * mesh.positions;
	ASSERT_GT(std::abs(boxDiagonal(mesh.positions) / diagonal - 1), 0.05);
	const CutReport slanted = cutIntoPanels(mesh, {}, {}).report;
	EXPECT_EQ(slanted.panels.size(), straight.panels.size());
	EXPECT_LE(slanted.maxDisplacement, 0.02 * boxDiagonal(mesh.positions));
	EXPECT_EQ(straight.status, Status::Converged);
	EXPECT_LE(straight.maxDisplacement, 0.02 * diagonal);
}

} // namespace
} // namespace developable::test
