// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(PatchMeasures, TellPatchesApart) {
	TriangleMesh cap = jitteredGrid(9, 9, sphereCap(1)), sheet = grid(4, 6, flatSheet);
	sheet.positions.row(2).array() += 3;
	const PatchAssembly assembly = assembled(together(sheet, cap));
	Positions positions = assembly.originalPositions;
	const int moved = 7;
	positions.col(moved) += Eigen::Vector3d(0.3, 0, 0.4);
	const std::vector<PatchMeasures> measures = measurePatches(assembly, positions);
	ASSERT_EQ(measures.size(), 2);
	EXPECT_EQ(measures[0].faces, sheet.triangleCount());
	EXPECT_DOUBLE_EQ(measures[0].maxDisplacement, 0.5);
	EXPECT_NEAR(measures[0].meanDisplacement, 0.5 / 24, 1e-15);
	EXPECT_GT(measures[0].curvature, 0.1);

	const PatchAssembly alone = assembled(cap);
	const Measures whole = measure(alone, alone.originalPositions, 1e-4);
	EXPECT_EQ(measures[1].faces, cap.triangleCount());
	EXPECT_NEAR(measures[1].curvature, whole.totalAbsoluteCurvature, 1e-14);
	EXPECT_EQ(measures[1].maxAngleDefect, whole.maxAngleDefect);
	EXPECT_EQ(measures[1].maxDisplacement, 0);
	Eigen::Index worst = 0;
	angleDefects(alone, alone.originalPositions).cwiseAbs().maxCoeff(&worst);
	EXPECT_EQ(measures[1].worstPoint, alone.originalPositions.col(alone.placeOfCopy[worst]));
}

} // namespace
} // namespace developable::test
