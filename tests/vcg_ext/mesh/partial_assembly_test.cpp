// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/partial_assembly.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

#include <set>

namespace developable::test {
namespace {

/// Whether the places of a part are those of the whole that it says they are.
void expectPlacesOf(const PatchAssembly& whole, const PartialAssembly& part) {
	EXPECT_EQ(part.assembly.originalPositions, whole.originalPositions(Eigen::all, part.wholePlace).eval());
	ASSERT_EQ(static_cast<int>(part.wholePlace.size()), part.assembly.placeCount());
	for (int place = 0; place < part.assembly.placeCount(); ++place)
		EXPECT_EQ(part.assembly.placeFixed[place], whole.placeFixed[part.wholePlace[place]]);
	const std::set<int> different(part.wholePlace.begin(), part.wholePlace.end());
	EXPECT_EQ(different.size(), part.wholePlace.size());
}

TEST(PartialAssembly, OfAllTrianglesIsTheWhole) {
	TriangleMesh mesh = together(grid(9, 5, sleeve(1e-3)), pyramid({5, 0, 0}, x, y, 0.3));
	mesh.vertexSelected[11] = 1;
	PatchOptions options = welding(1.001e-3);
	options.fixSelected = true;
	const PatchAssembly whole = assembled(mesh, options);
	ASSERT_EQ(whole.assemblingPlaceCount(), 5);
	const PartialAssembly part = partialAssembly(whole, whole.triangleCopies);
	expectPlacesOf(whole, part);
	expectCounts(part.assembly, 2, whole.placeCount(), whole.copyCount(), 5);
	EXPECT_EQ(part.assembly.joinedHalfEdge, whole.joinedHalfEdge);
	for (int corner = 0; corner < 3 * whole.triangleCount(); ++corner)
		EXPECT_EQ(part.wholePlace[part.assembly.placeAt(corner)], whole.placeAt(corner));
}

TEST(PartialAssembly, OfSomeTrianglesHasTheirPlacesOnly) {
	// The left half of a sheet, its lower rim held still.
	TriangleMesh mesh = jitteredGrid(9, 9, saddle);
	for (int vertex = 0; vertex < 9; ++vertex)
		mesh.vertexSelected[vertex] = 1;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly whole = assembled(mesh, options);
	const PartialAssembly part =
		partialAssembly(whole, trianglesWhere(whole.triangleCopies, [](int t) { return t / 2 % 8 < 4; }));
	expectPlacesOf(whole, part);
	expectCounts(part.assembly, 1, 5 * 9, 5 * 9, 0);
	EXPECT_EQ(part.assembly.interiorCopyCount(), 3 * 7);
	EXPECT_EQ(std::count(part.assembly.placeFixed.begin(), part.assembly.placeFixed.end(), 1), 5);
}

TEST(PartialAssembly, OpensWhereTrianglesAreLeftOutAndKeepsSeams) {
	const PatchAssembly ball = assembled(octahedron());
	ASSERT_TRUE(ball.patches[0].closed());
	const Eigen::Matrix3Xi allButOne = trianglesWhere(ball.triangleCopies, [](int t) { return t != 5; });
	EXPECT_EQ(partialAssembly(ball, allButOne).assembly.patches[0].boundaryEdges, 3);

	// The two patches on one edge, then one of them: nothing is left to assemble.
	const PatchAssembly pair = assembled(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)));
	expectCounts(partialAssembly(pair, pair.triangleCopies).assembly, 2, 8, 10, 2);
	const Eigen::Matrix3Xi first = trianglesWhere(pair.triangleCopies, [](int t) { return t < 4; });
	expectCounts(partialAssembly(pair, first).assembly, 1, 5, 5, 0);
}

TEST(PartialAssembly, KnowsWhichPatchesItHas) {
	const PatchAssembly three = assembled(
		together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)), pyramid(y, y, x, 0.4)));
	ASSERT_EQ(three.patchCount(), 3);
	const auto patchesOf = [&](const Eigen::Matrix3Xi& triangles) {
		return partialAssembly(three, triangles).wholePatch;
	};
	EXPECT_EQ(patchesOf(three.triangleCopies), std::vector<int>({0, 1, 2}));
	EXPECT_EQ(patchesOf(trianglesWhere(three.triangleCopies, [](int t) { return t > 6; })),
			  std::vector<int>({1, 2}));
	const Eigen::Matrix3Xi lastFirst = three.triangleCopies.rowwise().reverse();
	EXPECT_EQ(patchesOf(lastFirst), std::vector<int>({2, 1, 0}));
}

TEST(PartialAssembly, HasTheWholesOwnMeasureOfArea) {
	TriangleMesh mesh = pyramid(origin, x, y, 0.3);
	mesh.leastHeightRatio = 0.01;
	const PatchAssembly whole = assembled(mesh);
	EXPECT_EQ(partialAssembly(whole, whole.triangleCopies).assembly.leastHeightRatio, 0.01);
}

TEST(TrianglesWhere, KeepsTheirOrder) {
	Eigen::Matrix3Xi triangles(3, 5), odd(3, 2);
	triangles << 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14;
	odd << 1, 3, 6, 8, 11, 13;
	EXPECT_EQ(trianglesWhere(triangles, [](int t) { return t % 2 == 1; }), odd);
	EXPECT_EQ(trianglesWhere(triangles, [](int) { return false; }).cols(), 0);
}

} // namespace
} // namespace developable::test
