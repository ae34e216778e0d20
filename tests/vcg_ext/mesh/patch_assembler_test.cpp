// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/patch_assembler.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

namespace developable::test {
namespace {

TEST(PatchAssembler, OppositeOrientationsChangeNoDefect) {
	const TriangleMesh mesh = together(pyramid(origin, x, y, 0.4), pyramid(x, x, y, 0.7));
	TriangleMesh turned = mesh;
	for (const int triangle : {4, 5, 6, 7}) // the second patch
		std::swap(turned.triangles(0, triangle), turned.triangles(1, triangle));
	TriangleMesh mixed = turned;
	std::swap(mixed.triangles(1, 2), mixed.triangles(2, 2)); // one face of the first
	for (const TriangleMesh& each : {turned, mixed, shared(turned), shared(mixed)}) {
		const PatchAssembly assembly = assembled(each);
		expectDefects(assembly, {0.5, 0.5, 0.4}, {pyramidDefect(0.4)});
		expectDefects(assembly, {1.5, 0.5, 0.7}, {pyramidDefect(0.7)});
		for (const Patch& patch : assembly.patches)
			EXPECT_TRUE(patch.orientable);
	}
	// Apart, each patch has an orientation of its own; the one face that differs within a patch is known.
	const PatchAssembly apart = assembled(mixed);
	EXPECT_EQ(apart.patchCount(), 2);
	EXPECT_EQ(apart.triangleReversed, (std::vector<char>{0, 0, 1, 0, 0, 0, 0, 0}));
	// With shared vertices it is one patch whose halves disagree.
	const PatchAssembly one = assembled(shared(turned));
	EXPECT_EQ(one.patchCount(), 1);
	EXPECT_EQ(one.triangleReversed, (std::vector<char>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(PatchAssembler, MoebiusStripHasOneSideAndItsDefects) {
	const int columns = 24, rows = 5;
	TriangleMesh mesh = grid(columns + 1, rows, [](double u, double v) -> Point {
		const double angle = 2 * pi * u, across = v - 0.5;
		return {(2 + across * std::cos(angle / 2)) * std::cos(angle),
				(2 + across * std::cos(angle / 2)) * std::sin(angle), across * std::sin(angle / 2)};
	});
	for (int row = 0; row < rows; ++row) // the last column is the first one upside down
		mesh.positions.col(row * (columns + 1) + columns) =
			mesh.positions.col((rows - 1 - row) * (columns + 1));
	const PatchAssembly assembly = assembled(shared(mesh));
	expectCounts(assembly, 1, columns * rows, columns * rows, 0);
	const Patch& patch = assembly.patches[0];
	EXPECT_FALSE(patch.orientable);
	EXPECT_EQ(patch.eulerCharacteristic(), 0);
	EXPECT_EQ(patch.boundaryEdges, 2 * columns);
	EXPECT_EQ(assembly.interiorCopyCount(), columns * (rows - 2));
	EXPECT_EQ(
		messageOf<NonOrientablePatch>([&] { requireOrientablePatches(assembly); }).rfind("1 patch has", 0),
		0u);
	EXPECT_NO_THROW(requireOpenPatches(assembly));

	// Angles know no sides: where the strip is sewn, and elsewhere.
	Eigen::VectorXd expected = Eigen::VectorXd::Constant(assembly.placeCount(), 2 * pi);
	for (const auto& t : assembly.trianglePlaces.colwise())
		for (int corner = 0; corner < 3; ++corner)
			expected[t[corner]] -= angleAt(assembly.originalPositions.col(t[corner]),
										   assembly.originalPositions.col(t[nextCorner(corner)]),
										   assembly.originalPositions.col(t[previousCorner(corner)]));
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		EXPECT_NEAR(defects[copy], assembly.copyInterior[copy] ? expected[assembly.placeOfCopy[copy]] : 0,
					1e-12);
	EXPECT_GT(defects.cwiseAbs().maxCoeff(), 1e-3);

	// Cut along its seam, it has two.
	EXPECT_TRUE(assembled(mesh).patches[0].orientable);
	EXPECT_EQ(assembled(mesh).assemblingPlaceCount(), rows);
}

TEST(PatchAssembler, ClosedPatchesAddUpToTheirEulerCharacteristic) {
	// A torus of 12 x 9: closed, and its angle defects cancel.
	const TriangleMesh torus = grid(13, 10, [](double u, double v) -> Point {
		const double a = u < 1 ? 2 * pi * u : 0, b = v < 1 ? 2 * pi * v : 0;
		return {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)};
	});
	const PatchAssembly assembly = assembled(shared(torus));
	EXPECT_TRUE(assembly.patches[0].closed());
	EXPECT_EQ(assembly.patches[0].eulerCharacteristic(), 0);
	EXPECT_NEAR(angleDefects(assembly, assembly.originalPositions).sum(), 0, 1e-11);
	// With its seams it is one open patch, sewn to itself at two seams that cross in a vertex of four copies.
	const PatchAssembly open = assembled(torus);
	EXPECT_NO_THROW(requireOpenPatches(open));
	expectCounts(open, 1, 12 * 9, 13 * 10, 12 + 9 - 1);
	expectDefects(open, {4, 0, 0}, {0, 0, 0, 0});
}

TEST(PatchAssembler, OnlySelectedKeepsTheSelectedPatchesAndHoldsTheirNeighbours) {
	const TriangleMesh mesh = oneSelectedOfThree();
	const PatchAssembly assembly = assembled(mesh, selectedOnly());
	expectCounts(assembly, 1, 5, 5, 2);
	EXPECT_EQ(assembly.faceOfTriangle, (std::vector<int>{0, 1, 2, 3}));
	expectDefects(assembly, {0.5, 0.5, 0.2}, {pyramidDefect(0.2)});
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		EXPECT_EQ(assembly.placeOfVertex[vertex] >= 0, vertex < 5);
	for (const int vertex : {0, 1, 2, 3, 4}) { // 1 and 2 lie on the seam with a patch that holds still
		const int place = assembly.placeOfVertex[vertex];
		EXPECT_EQ(assembly.placeFixed[place], vertex == 1 || vertex == 2);
		EXPECT_EQ(assembly.placeAssembling[place], vertex == 1 || vertex == 2);
	}
}

TEST(PatchAssembler, OnlySelectedLetsWeldedVerticesComeToThoseThatHoldStill) {
	TriangleMesh mesh = oneSelectedOfThree();
	mesh.positions.middleCols(5, 5).row(2).array() += 0.01; // the neighbour
	const PatchAssembly assembly = assembled(mesh, selectedOnly(0.011));
	for (const int vertex : {1, 2})
		EXPECT_EQ(assembly.originalPositions.col(assembly.placeOfVertex[vertex]),
				  mesh.positions.col(vertex == 1 ? 5 : 8));
}

TEST(PatchAssembler, FixBoundaryHoldsEveryPlaceThatIsOnSomeBoundary) {
	// The apex of the first is inside it, and a corner of the second.
	const Point apex(0.5, 0.5, 0.5);
	const TriangleMesh mesh = together(pyramid(origin, x, y, 0.5), pyramid(apex, y, z, 0.3));
	PatchOptions options;
	options.fixBoundary = true;
	const PatchAssembly assembly = assembled(mesh, options);
	const int freePlace = assembly.placeOfVertex[9];
	for (int place = 0; place < assembly.placeCount(); ++place)
		EXPECT_EQ(assembly.placeFixed[place], place != freePlace);
	EXPECT_NO_THROW(requireFreePlaces(assembly));
}

TEST(PatchAssembler, FixSelectedHoldsAllThatIsLinkedToASelectedVertex) {
	TriangleMesh mesh = together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9));
	mesh.vertexSelected[5] = 1; // the second's corner at x
	PatchOptions options;
	EXPECT_EQ(assembled(mesh).placeFixed, std::vector<char>(8, 0));
	options.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, options);
	for (int place = 0; place < assembly.placeCount(); ++place)
		EXPECT_EQ(assembly.placeFixed[place], place == assembly.placeOfVertex[1]);
	mesh.vertexSelected.assign(mesh.vertexCount(), 1);
	const PatchAssembly nothingFree = assembled(mesh, options);
	EXPECT_EQ(messageOf<NothingFree>([&] { requireFreePlaces(nothingFree); }).rfind("All 8 vertices are", 0),
			  0u);
}

} // namespace
} // namespace developable::test
