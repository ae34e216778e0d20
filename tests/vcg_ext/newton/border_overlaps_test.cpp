// SPDX-License-Identifier: GPL-3.0-or-later
// Borders whose angles add up to more than a full turn.
#include "support/corkscrew.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

constexpr int outerPlaces = 9; // of a corkscrew

TEST(BorderOverlaps, GoFromBordersThatWereFarFromThem) {
	// The original has 4 rad at the middle, the start more than a full turn.
	const PatchAssembly assembly = assembled(corkscrew(4));
	Positions positions = corkscrew(6.6).positions;
	ASSERT_GT(borderAngles(assembly, positions).maxCoeff(), 2 * pi + 0.1);
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 10;
	EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
	EXPECT_LE(borderAngles(assembly, positions).maxCoeff(), 2 * pi + options.angleTolerance);
	expectSound(assembly, positions);
}

void expectBlamesBorder(const ConstrainedNewtonReport& report, Status status, const Positions& positions) {
	EXPECT_EQ(report.status, status);
	EXPECT_EQ(report.reason, Reason::BorderOverlaps);
	EXPECT_EQ(report.borderOverlaps, 1);
	EXPECT_EQ(report.worstCopy, 0); // the middle
	const Eigen::Vector3d worst(report.worstPosition.data());
	EXPECT_EQ(worst, positions.col(0));
	ASSERT_EQ(report.patchVerdicts.size(), 1U);
	EXPECT_EQ(report.patchVerdicts[0].status, status);
	EXPECT_EQ(report.patchVerdicts[0].reason, Reason::BorderOverlaps);
	EXPECT_EQ(report.patchVerdicts[0].borderOverlaps, 1);
}

TEST(BorderOverlaps, AreNamedWhereTheyStayThoughNoCurvatureIsLeft) {
	TriangleMesh mesh = corkscrew(6.6);
	PatchOptions still;
	still.fixSelected = true;
	for (int vertex = 0; vertex < outerPlaces; ++vertex) // all but the last
		mesh.vertexSelected[vertex] = vertex != 4;
	mesh.vertexSelected[outerPlaces] = 1;
	const PatchAssembly assembly = assembled(mesh, still);
	Positions positions = assembly.originalPositions;
	expectBlamesBorder(constrainedNewton(assembly, positions, {}), Status::Stalled, positions);
}

TEST(BorderOverlaps, AreNamedWhereTheWorkIsSpent) {
	const PatchAssembly assembly = assembled(corkscrew(6.6));
	Positions positions = assembly.originalPositions;
	ConstrainedNewtonOptions options;
	options.tuning.workPerPlace = options.tuning.workOnSmall = 0;
	options.tuning.curvatureSteps = 0;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, options);
	expectBlamesBorder(report, Status::NeedsCut, positions);
	EXPECT_EQ(report.patchesNeedingCut, 1);
}

TEST(BorderOverlaps, AreNotBlamedForCurvature) {
	// One patch overlaps itself, another has curvature that it can't lose: the verdict is about that.
	TriangleMesh mesh = together(corkscrew(6.6), grid(4, 4, saddle));
	PatchOptions still;
	still.fixSelected = true;
	mesh.vertexSelected.assign(mesh.vertexSelected.size(), 1);
	mesh.vertexSelected[4] = mesh.vertexSelected[outerPlaces + 1] = 0;
	const PatchAssembly assembly = assembled(mesh, still);
	Positions positions = assembly.originalPositions;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(report.reason, Reason::AsStatus);
	EXPECT_EQ(report.borderOverlaps, 0);
	ASSERT_EQ(report.patchVerdicts.size(), 2U);
	EXPECT_EQ(report.patchVerdicts[0].reason, Reason::BorderOverlaps);
	EXPECT_EQ(report.patchVerdicts[1].reason, Reason::AsStatus);
}

} // namespace
} // namespace developable::test
