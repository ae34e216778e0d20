// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/patch_assembly.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

#include <limits>

namespace developable::test {
namespace {

TEST(PatchAssembly, CornersHalfEdgesAndCopiesAgree) {
	for (const TriangleMesh& mesh : {octahedron(), grid(7, 4, sleeve(0)), oneSelectedOfThree()}) {
		const PatchAssembly assembly = assembled(mesh);
		const int corners = 3 * assembly.triangleCount();
		for (int corner = 0; corner < corners; ++corner) {
			EXPECT_EQ(assembly.copyAt(corner),
					  assembly.triangleCopies(cornerInTriangle(corner), triangleOf(corner)));
			EXPECT_EQ(assembly.placeAt(corner), assembly.placeOfCopy[assembly.copyAt(corner)]);
			EXPECT_EQ(assembly.placeAt(corner), assembly.placeOfVertex[vertexAt(mesh, corner)]);
			if (assembly.across(corner) >= 0) {
				EXPECT_EQ(assembly.across(assembly.across(corner)), corner);
			}
		}
		ASSERT_EQ(static_cast<int>(assembly.corners.size()), corners);
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			for (int i = assembly.cornerStart[copy]; i < assembly.cornerStart[copy + 1]; ++i) {
				EXPECT_EQ(assembly.copyAt(assembly.corners[i]), copy);
				EXPECT_TRUE(i == assembly.cornerStart[copy] || assembly.corners[i - 1] < assembly.corners[i]);
			}
	}
}

TEST(PatchAssembly, EdgesKnowTheirHalfEdgesAndLengths) {
	const double height = 0.3;
	const PatchAssembly assembly = assembled(pyramid(origin, x, y, height));
	const Eigen::VectorXd lengths = edgeLengths(assembly, assembly.originalPositions);
	ASSERT_EQ(assembly.edgeCount(), 8);
	const double ridge = std::sqrt(0.5 + height * height);
	for (int edge = 0; edge < 8; ++edge) {
		const int h = assembly.edgeHalfEdge[edge];
		EXPECT_EQ(assembly.placeAt(h), assembly.edgePlaces(0, edge));
		EXPECT_EQ(assembly.placeAt(nextCorner(h)), assembly.edgePlaces(1, edge));
		EXPECT_NEAR(lengths[edge], assembly.across(h) < 0 ? 1 : ridge, 1e-15);
	}
	EXPECT_NEAR(meanEdgeLength(assembly), (1 + ridge) / 2, 1e-15);
	// Of the given positions, not of the original ones.
	EXPECT_NEAR(edgeLengths(assembly, 2 * assembly.originalPositions).sum(), 8 * (1 + ridge), 1e-14);
}

TEST(PatchAssembly, TriangleHasNoAreaBelowAShareOfItsLongestEdge) {
	PatchAssembly assembly = assembled(fan({0.5, 0.3, 0}, {origin, x, y}));
	const int apex = 3;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(zeroAreaTriangles(assembly, positions).size(), 0);
	for (const double scale : {1e-6, 1.0, 1e6}) {
		positions = assembly.originalPositions;
		positions(1, apex) = 0.02; // the height over the edge from the origin to x, of length 1
		positions *= scale;
		assembly.leastHeightRatio = 0.019;
		EXPECT_EQ(zeroAreaTriangles(assembly, positions).size(), 0);
		assembly.leastHeightRatio = 0.021;
		EXPECT_EQ(zeroAreaTriangles(assembly, positions).size(), 1);
	}
	positions.col(apex) = positions.col(0); // flat are the two triangles at their common edge
	EXPECT_EQ(zeroAreaTriangles(assembly, positions).size(), 2);
	EXPECT_EQ(zeroAreaTriangles(assembly, Positions::Zero(3, 4)).size(), 3);
	positions = assembly.originalPositions;
	positions(2, 0) = std::numeric_limits<double>::quiet_NaN();
	EXPECT_EQ(zeroAreaTriangles(assembly, positions).size(), 2);
}

} // namespace
} // namespace developable::test
