// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(ElasticEnergy, IsZeroForTheOriginalShapeAndAnyRigidMotionOfIt) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 7, bumpedCylinder));
	const Eigen::VectorXd lengths = edgeLengths(assembly, assembly.originalPositions);
	EXPECT_EQ(elasticEnergy(assembly, assembly.originalPositions, lengths), 0);
	const Positions elsewhere = moved(assembly.originalPositions, 1, Eigen::Vector3d(5, 1, -2));
	EXPECT_LT(elasticEnergy(assembly, elsewhere, lengths), 1e-25);
}

TEST(ElasticEnergy, OfAStretchIsTheSumOfSquaredChangesOfLength) {
	// A right triangle with legs 3 and 4, twice as large: its sides grow by 3, 4 and 5.
	Positions positions(3, 3);
	positions << 0, 3, 0, 0, 0, 4, 0, 0, 0;
	const PatchAssembly assembly = assembled(makeMesh(positions, Eigen::Vector3i(0, 1, 2)));
	const Eigen::VectorXd lengths = edgeLengths(assembly, positions);
	EXPECT_DOUBLE_EQ(elasticEnergy(assembly, 2 * positions, lengths), 9 + 16 + 25);
}

TEST(ElasticEnergy, CountsAnEdgeThatTwoPatchesShareInEach) {
	Positions positions(3, 6);
	positions << 0, 1, 0, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0;
	Eigen::Matrix3Xi triangles(3, 2);
	triangles << 0, 3, 1, 5, 2, 4; // two patches that meet along (1,0)-(0,1)
	const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
	ASSERT_EQ(assembly.patchCount(), 2);
	EXPECT_EQ(assembly.placeCount(), 4);
	EXPECT_EQ(assembly.edgeCount(), 6);
	EXPECT_NEAR(elasticEnergy(assembly, 2 * assembly.originalPositions,
							  edgeLengths(assembly, assembly.originalPositions)),
				4 * 1 + 2 * 2, 1e-14);
}

TEST(ElasticEnergy, GradientAgreesWithCentralDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 7, saddle));
	const Eigen::VectorXd lengths = 1.1 * edgeLengths(assembly, assembly.originalPositions);
	const auto function = [&](const Positions& p) { return elasticEnergy(assembly, p, lengths); };
	const Positions differences = centralDifferences(function, assembly.originalPositions);
	const Positions gradient = elasticEnergyGradient(assembly, assembly.originalPositions, lengths);
	EXPECT_LT((gradient - differences).norm(), 1e-8 * differences.norm());
}

} // namespace
} // namespace developable::test
