// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/mesh.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TriangleMesh shifted(TriangleMesh mesh, double shift) {
	mesh.positions.row(2).array() += shift;
	return mesh;
}

/// Two sheets sewn together at x = 1.
TriangleMesh sewn(int columns) {
	const TriangleMesh left = jitteredGrid(columns, columns, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 2 - right.positions.row(0).array();
	return together(left, right);
}

void expectSame(const PatchAssembly& a, const PatchAssembly& b) {
	EXPECT_EQ(a.originalPositions, b.originalPositions);
	EXPECT_EQ(a.placeFixed, b.placeFixed);
	EXPECT_EQ(a.placeAssembling, b.placeAssembling);
	EXPECT_EQ(a.placeOfCopy, b.placeOfCopy);
	EXPECT_EQ(a.patchOfCopy, b.patchOfCopy);
	EXPECT_EQ(a.copyInterior, b.copyInterior);
	EXPECT_EQ(a.cornerStart, b.cornerStart);
	EXPECT_EQ(a.corners, b.corners);
	EXPECT_EQ(a.triangleCopies, b.triangleCopies);
	EXPECT_EQ(a.trianglePlaces, b.trianglePlaces);
	EXPECT_EQ(a.patchOfTriangle, b.patchOfTriangle);
	EXPECT_EQ(a.triangleReversed, b.triangleReversed);
	EXPECT_EQ(a.joinedHalfEdge, b.joinedHalfEdge);
	EXPECT_EQ(a.edgePlaces, b.edgePlaces);
	EXPECT_EQ(a.edgeHalfEdge, b.edgeHalfEdge);
	ASSERT_EQ(a.patchCount(), b.patchCount());
	for (int patch = 0; patch < a.patchCount(); ++patch)
		EXPECT_EQ(a.patches[patch].eulerCharacteristic(), b.patches[patch].eulerCharacteristic());
}

TEST(AssemblyParts, OfWhatHangsTogetherIsTheWhole) {
	const PatchAssembly whole = assembled(sewn(7));
	const std::vector<AssemblyPart> parts = partsOf(whole);
	ASSERT_EQ(parts.size(), 1);
	expectSame(parts[0].assembly, whole);
	EXPECT_EQ(parts[0].assembly.faceOfTriangle, whole.faceOfTriangle);
	EXPECT_EQ(parts[0].wholePatch, (std::vector<int>{0, 1}));
}

TEST(AssemblyParts, AreWhatEachIsByItself) {
	const TriangleMesh single = shifted(jitteredGrid(6, 9, wave), 3), pair = sewn(5);
	TriangleMesh mesh = together(single, pair);
	// Triangles and so patches of the two take turns.
	std::vector<int> order;
	for (int t = 0; t < std::max(single.triangleCount(), pair.triangleCount()); ++t) {
		if (t < pair.triangleCount())
			order.push_back(single.triangleCount() + t);
		if (t < single.triangleCount())
			order.push_back(t);
	}
	mesh.triangles = Eigen::Matrix3Xi(mesh.triangles(Eigen::all, order));
	const PatchAssembly whole = assembled(mesh);
	const std::vector<AssemblyPart> parts = partsOf(whole);
	ASSERT_EQ(parts.size(), 2);
	expectSame(parts[0].assembly, assembled(pair));
	expectSame(parts[1].assembly, assembled(single));
	for (const AssemblyPart& part : parts)
		EXPECT_EQ(part.assembly.originalPositions, whole.originalPositions(Eigen::all, part.wholePlace));
}

TEST(AssemblyParts, HangTogetherWherePatchesOnlyTouch) {
	TriangleMesh mesh = together(grid(3, 3, flatSheet), grid(3, 3, flatSheet));
	mesh.positions.rightCols(9).colwise() += Eigen::Vector3d(1, 1, 0); // at a corner
	EXPECT_EQ(partsOf(assembled(mesh)).size(), 1);
	mesh.positions.rightCols(9).colwise() += Eigen::Vector3d(1e-3, 0, 0);
	EXPECT_EQ(partsOf(assembled(mesh)).size(), 2);
}

} // namespace
} // namespace developable::test
