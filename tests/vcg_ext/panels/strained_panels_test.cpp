// SPDX-License-Identifier: GPL-3.0-or-later
// What a material that gives does to a cut.
#include "developable/flatten/flatten.h"
#include "developable/panels/cut_into_panels.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// z = −(x² + y²) / 2 over the unit disk's square: a dome whose pattern needs strain.
Eigen::Vector3d dome(double u, double v) {
	const double x = u - 0.5, y = v - 0.5;
	return {x, y, -(x * x + y * y) / 2};
}

CutOptions strained(double bound, double maxDisplacement) {
	CutOptions options;
	options.material.bounds = StrainBounds::isotropic(bound, bound);
	options.maxDisplacement = maxDisplacement;
	return options;
}

/// The least bound, of both signs, within which the mesh has a pattern without moving; to a twentieth.
double boundThatFits(const TriangleMesh& mesh) {
	const PatchAssembly assembly = assembled(mesh);
	double low = 0, high = 0.2;
	while (high - low > 0.05 * high) {
		const double middle = (low + high) / 2;
		FlattenOptions options;
		options.bounds = StrainBounds::isotropic(middle, middle);
		const bool fits =
			flattenPatches(assembly, assembly.originalPositions, options).report.beyondBounds <= 1e-4;
		(fits ? high : low) = middle;
	}
	return high;
}

TEST(StrainedPanels, whatFitsIsNotCutAndWhatDoesNotIs) {
	const TriangleMesh mesh = grid(9, 9, dome);
	const double bound = boundThatFits(mesh);
	const CutResult whole = cutIntoPanels(mesh, {}, strained(1.1 * bound, 0));
	EXPECT_EQ(whole.report.status, Status::NothingToDo);
	EXPECT_EQ(whole.report.panels.size(), 1U);
	EXPECT_EQ(whole.report.maxDisplacement, 0);
	EXPECT_EQ(whole.mesh.triangles, mesh.triangles);
	const CutResult cut = cutIntoPanels(mesh, {}, strained(0.8 * bound, 0));
	EXPECT_EQ(cut.report.status, Status::Converged);
	EXPECT_GT(int(cut.report.panels.size()) + cut.report.darts, 1);
	EXPECT_EQ(cut.report.maxDisplacement, 0);
	for (const CutPanel& panel : cut.report.panels) {
		EXPECT_TRUE(panel.developable);
		EXPECT_LE(panel.beyondBounds, patternTolerance);
		EXPECT_GT(panel.curvatureAfter, 1e-3);
	}
}

TEST(StrainedPanels, badBoundsAreRefused) {
	const TriangleMesh mesh = grid(4, 4, dome);
	for (const double bound : {-0.1, 1.0, std::nan("")})
		EXPECT_THROW(cutIntoPanels(mesh, {}, strained(bound, 0)), InvalidParameter);
}

TEST(StrainedPanels, whatMayNotBeCutSaysHowFarItWouldMove) {
	TriangleMesh mesh = grid(9, 9, dome);
	mesh.triangleSelected.assign(mesh.triangleCount(), 1);
	CutOptions options = strained(0.2 * boundThatFits(mesh), 0);
	options.keepSelected = true;
	const CutResult cut = cutIntoPanels(mesh, {}, options);
	EXPECT_EQ(cut.report.status, Status::NeedsCut);
	ASSERT_EQ(cut.report.panels.size(), 1U);
	EXPECT_FALSE(cut.report.panels[0].developable);
	EXPECT_EQ(cut.report.panels[0].reason, Reason::TooFar);
	EXPECT_GT(cut.report.panels[0].maxDisplacement, 0);
	EXPECT_LE(cut.report.panels[0].beyondBounds, patternTolerance);
	EXPECT_EQ(cut.mesh.triangles, mesh.triangles);
}

} // namespace
} // namespace developable::test
