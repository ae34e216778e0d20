// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/joined_faces.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

namespace developable::test {
namespace {

/// The half edges of each edge, as visited.
std::vector<std::vector<int>> edgesOf(const TriangleMesh& mesh) {
	std::vector<std::vector<int>> edges;
	HalfEdgesByEnds(mesh).forEachEdge([&](auto first, auto last) { edges.emplace_back(first, last); });
	return edges;
}

TEST(HalfEdgesByEnds, VisitsEveryEdgeOnceWithAllOfItsHalfEdges) {
	Eigen::Matrix3Xi triangles(3, 3);
	triangles << 0, 1, 0, 1, 0, 1, 2, 3, 4; // three pages on the edge 0 1
	const TriangleMesh book = makeMesh(Positions::Random(3, 5), triangles);
	int pages = 0;
	for (const auto& halfEdges : edgesOf(book))
		pages += halfEdges == std::vector<int>{0, 3, 6};
	EXPECT_EQ(pages, 1);
	EXPECT_EQ(edgesOf(book).size(), 7u);

	std::vector<int> visited;
	for (const auto& halfEdges : edgesOf(octahedron())) {
		EXPECT_EQ(halfEdges.size(), 2u);
		visited.insert(visited.end(), halfEdges.begin(), halfEdges.end());
	}
	std::sort(visited.begin(), visited.end());
	std::vector<int> all(24);
	std::iota(all.begin(), all.end(), 0);
	EXPECT_EQ(visited, all);
}

TEST(JoinedFaces, CornerAcrossAnEdgeLiesAtTheSameVertex) {
	TriangleMesh mesh = grid(4, 4, saddle);
	for (const bool turned : {false, true}) {
		if (turned)
			std::swap(mesh.triangles(0, 7), mesh.triangles(1, 7));
		const std::vector<int> joined = joinedHalfEdges(mesh);
		int inner = 0;
		for (int h = 0; h < 3 * mesh.triangleCount(); ++h) {
			if (joined[h] < 0)
				continue;
			++inner;
			EXPECT_EQ(joined[joined[h]], h);
			EXPECT_NE(triangleOf(joined[h]), triangleOf(h));
			for (const int corner : {h, nextCorner(h)}) {
				const int across = cornerAcross(mesh, corner, joined[h]);
				EXPECT_EQ(vertexAt(mesh, across), vertexAt(mesh, corner));
				EXPECT_EQ(triangleOf(across), triangleOf(joined[h]));
			}
		}
		EXPECT_EQ(inner, 3 * 18 - 12); // but for the rim
	}
}

TEST(JoinedFaces, SeamNeedsALabelThatDiffersAtOneEndOnly) {
	TriangleMesh mesh = fan({0.5, 0.5, 0.3}, {origin, x, y});
	mesh.cornerLabel.assign(9, 0);
	const int h = 1, other = joinedHalfEdges(mesh)[h]; // between the triangles 0 and 1
	ASSERT_EQ(triangleOf(other), 1);
	EXPECT_FALSE(isSeam(mesh, h, other));
	mesh.cornerLabel[h] = 1;
	EXPECT_TRUE(isSeam(mesh, h, other));
	EXPECT_TRUE(isSeam(mesh, other, h));
	mesh.cornerLabel[cornerAcross(mesh, h, other)] = 1;
	EXPECT_FALSE(isSeam(mesh, h, other));
	mesh.cornerLabel[previousCorner(h)] = 2; // not of this edge
	EXPECT_FALSE(isSeam(mesh, h, other));
}

TEST(JoinedFaces, EdgeInsideOnePatchAndOnAnothersBoundary) {
	// A pocket whose lower edge lies on an edge inside the sheet below it.
	const Point a(0.5, 0.5, 0.2), b(1.5, 0.5, 0.1);
	const std::vector<Point> ringOfA = {origin, x, b, Point(1, 1, 0), y},
							 ringOfB = {a, x, 2 * x, Point(2, 1, 0), Point(1, 1, 0)};
	Positions positions(3, 8);
	positions << origin, x, 2 * x, y, Point(1, 1, 0), Point(2, 1, 0), a, b;
	Eigen::Matrix3Xi triangles(3, 8);
	triangles << 0, 1, 1, 2, 5, 4, 4, 3, //
		1, 7, 2, 5, 4, 6, 3, 0,          //
		6, 6, 7, 7, 7, 7, 6, 6;
	const TriangleMesh pocket = pyramid(a, b - a, z, 0.25);
	const double pocketDefect = fanDefect(pocket.positions.col(4), {a, b, b + z, a + z});

	// As vertices of its own the pocket leaves the sheet whole.
	const TriangleMesh both = together(makeMesh(positions, triangles), pocket);
	const PatchAssembly assembly = assembled(both);
	expectCounts(assembly, 2, 11, 13, 2);
	expectDefects(assembly, a, {fanDefect(a, ringOfA), 0});
	expectDefects(assembly, b, {fanDefect(b, ringOfB), 0});
	expectDefects(assembly, pocket.positions.col(4), {pocketDefect});

	// With the sheet's vertices their edge has three faces: a slit in the sheet, whose ends are its boundary.
	const PatchAssembly slit = assembled(shared(both));
	expectCounts(slit, 2, 11, 13, 2);
	expectDefects(slit, a, {0, 0});
	expectDefects(slit, b, {0, 0});
	expectDefects(slit, pocket.positions.col(4), {pocketDefect});
}

TEST(JoinedFaces, ThreePatchesOnOneEdge) {
	// Pyramids of different heights, hinged on the edge from the origin along x.
	const std::array<double, 3> heights = {0.5, 1 / std::sqrt(2), 0.1};
	TriangleMesh mesh;
	std::array<Point, 3> apexes;
	for (int i = 0; i < 3; ++i) {
		const Point side = Eigen::AngleAxisd(2.1 * i, x) * y;
		const TriangleMesh leaf = pyramid(origin, x, side, heights[i]);
		apexes[i] = leaf.positions.col(4);
		mesh = i == 0 ? leaf : together(mesh, leaf);
	}
	for (const TriangleMesh& each : {mesh, shared(mesh)}) {
		const PatchAssembly assembly = assembled(each);
		expectCounts(assembly, 3, 2 + 3 * 3, 3 * 5, 2);
		EXPECT_EQ(assembly.edgeCount(), 3 * 8); // the hinge counts once in each
		expectDefects(assembly, origin, {0, 0, 0});
		expectDefects(assembly, x, {0, 0, 0});
		for (int i = 0; i < 3; ++i)
			expectDefects(assembly, apexes[i], {pyramidDefect(heights[i])});
		EXPECT_NEAR(pyramidDefect(heights[1]), 2 * pi / 3, 1e-15); // four equilateral triangles
	}
}

TEST(JoinedFaces, FourFacesOnOneEdgeSeparateFourPatches) {
	Positions positions(3, 6);
	positions << origin, z, x, y, -x, -y;
	Eigen::Matrix3Xi triangles(3, 4);
	triangles << 0, 0, 0, 0, 1, 1, 1, 1, 2, 3, 4, 5;
	const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
	expectCounts(assembly, 4, 6, 12, 2);
	expectDefects(assembly, origin, {0, 0, 0, 0});
}

TEST(JoinedFaces, BowTieBetweenTwoPatches) {
	const TriangleMesh both = together(pyramid(origin, x, y, 0.3), pyramid(origin, -x, -y, 0.6));
	for (const TriangleMesh& mesh : {both, shared(both)}) {
		const PatchAssembly assembly = assembled(mesh);
		expectCounts(assembly, 2, 9, 10, 1);
		expectDefects(assembly, origin, {0, 0});
		expectDefects(assembly, {0.5, 0.5, 0.3}, {pyramidDefect(0.3)});
		expectDefects(assembly, {-0.5, -0.5, 0.6}, {pyramidDefect(0.6)});
	}
}

TEST(JoinedFaces, BowTieOfTwoInteriorFans) {
	// Two pyramids with their apexes at one vertex: interior in both.
	const Point apex(0.5, 0.5, 0.5);
	const TriangleMesh both = together(pyramid(origin, x, y, 0.5), pyramid({0, 0, 0.8}, x, y, -0.3));
	for (const TriangleMesh& mesh : {both, shared(both)}) {
		const PatchAssembly assembly = assembled(mesh);
		expectCounts(assembly, 2, 9, 10, 1);
		expectDefects(assembly, apex, {pyramidDefect(0.5), pyramidDefect(0.3)});
	}
}

TEST(JoinedFaces, BowTieWithinOnePatch) {
	// A sheet of 4 x 4 cells that lacks two which meet at its middle: the patch touches itself there.
	const TriangleMesh whole = grid(5, 5, flatSheet);
	Eigen::Matrix3Xi triangles(3, whole.triangleCount() - 4);
	int next = 0;
	for (int t = 0; t < whole.triangleCount(); ++t) {
		const int cell = t / 2, row = cell / 4, column = cell % 4;
		if (!(row == column && (row == 1 || row == 2)))
			triangles.col(next++) = whole.triangles.col(t);
	}
	const PatchAssembly assembly = assembled(makeMesh(whole.positions, triangles));
	expectCounts(assembly, 1, 25, 26, 1);
	expectDefects(assembly, {0.5, 0.5, 0}, {0, 0});
	EXPECT_EQ(assembly.patches[0].eulerCharacteristic(),
			  0);                               // both holes are one, as the corner is not joined
	EXPECT_EQ(assembly.interiorCopyCount(), 2); // the corners that no hole touches
}

TEST(JoinedFaces, SeamsGivenByLabels) {
	// An octahedron, a label for each half: two pyramids that share their rim.
	TriangleMesh mesh = octahedron();
	mesh.cornerLabel.resize(24);
	for (int corner = 0; corner < 24; ++corner)
		mesh.cornerLabel[corner] = corner / 12;
	const PatchAssembly assembly = assembled(mesh);
	expectCounts(assembly, 2, 6, 10, 4);
	EXPECT_NO_THROW(requireOpenPatches(assembly));
	expectDefects(assembly, z, {2 * pi / 3});
	expectDefects(assembly, -z, {2 * pi / 3});
	for (const Point& point : {x, y, Point(-x), Point(-y)})
		expectDefects(assembly, point, {0, 0});
}

TEST(JoinedFaces, SeamThatEndsInsideAPatchIsASlit) {
	// Labels differ above and below the middle row, from the middle to the right edge; the sheet is bent
	// there.
	TriangleMesh mesh = grid(5, 5, saddle);
	mesh.cornerLabel.resize(3 * mesh.triangleCount());
	for (int corner = 0; corner < 3 * mesh.triangleCount(); ++corner) {
		const int vertex = vertexAt(mesh, corner), cellRow = corner / 6 / 4;
		const bool besideSlit = vertex == 13 || vertex == 14; // its vertices but for its inner end, 12
		mesh.cornerLabel[corner] = besideSlit && cellRow >= 2 ? 100 + vertex : vertex;
	}
	const PatchAssembly assembly = assembled(mesh);
	expectCounts(assembly, 1, 25, 27, 2);
	EXPECT_EQ(assembly.patches[0].eulerCharacteristic(), 1);
	expectDefects(assembly, mesh.positions.col(12), {0}); // on the boundary now
	expectDefects(assembly, mesh.positions.col(13), {0, 0});
	expectDefects(assembly, mesh.positions.col(14), {0, 0});
	EXPECT_EQ(assembly.interiorCopyCount(), 9 - 2);
}

} // namespace
} // namespace developable::test
