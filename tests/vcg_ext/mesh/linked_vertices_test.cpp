// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/linked_vertices.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

namespace developable::test {
namespace {

TEST(LinkedVertices, VertexInsideOnePatchAndOnAnothersBoundary) {
	// Fig. 4: a pyramid, and one with its base's corner at the other's apex.
	const double height = 0.5;
	const Point apex(0.5, 0.5, height);
	const TriangleMesh both = together(pyramid(origin, x, y, height), pyramid(apex, y, z, 0.3));
	for (const TriangleMesh& mesh : {both, shared(both)}) {
		const PatchAssembly assembly = assembled(mesh);
		expectCounts(assembly, 2, 9, 10, 1);
		expectDefects(assembly, apex, {pyramidDefect(height), 0});
		expectDefects(assembly, apex + (y + z) / 2 + 0.3 * x, {pyramidDefect(0.3)});
		EXPECT_EQ(assembly.interiorCopyCount(), 2);
	}
}

TEST(LinkedVertices, SleeveSewnToItself) {
	const int columns = 13, rows = 6;
	const PatchAssembly open = assembled(grid(columns, rows, sleeve(0)));
	expectCounts(open, 1, (columns - 1) * rows, columns * rows, rows);
	EXPECT_EQ(open.patches[0].eulerCharacteristic(), 1);
	EXPECT_EQ(open.interiorCopyCount(), (columns - 2) * (rows - 2));

	// The same sleeve without a seam: the defects off the seam are the same, those on it are lost to the
	// seam.
	const PatchAssembly closed = assembled(shared(grid(columns, rows, sleeve(0))));
	expectCounts(closed, 1, (columns - 1) * rows, (columns - 1) * rows, 0);
	EXPECT_EQ(closed.patches[0].eulerCharacteristic(), 0);
	for (int row = 1; row + 1 < rows; ++row)
		for (int column = 0; column + 1 < columns; ++column) {
			const Point point = sleeve(0)(double(column) / (columns - 1), double(row) / (rows - 1));
			const double defect = defectsAt(closed, placeAt(closed, point))[0];
			EXPECT_GT(std::abs(defect), 1e-3);
			expectDefects(open, point, column == 0 ? std::vector<double>{0, 0} : std::vector<double>{defect});
		}
}

TEST(LinkedVertices, SleeveSewnToItselfAcrossAGap) {
	const TriangleMesh mesh = grid(13, 6, sleeve(1e-3));
	EXPECT_EQ(assembled(mesh).assemblingPlaceCount(), 0);
	const PatchAssembly assembly = assembled(mesh, welding(1.001e-3));
	expectCounts(assembly, 1, 12 * 6, 13 * 6, 6);
	for (int row = 0; row < 6; ++row) {
		const int place = assembly.placeOfVertex[13 * row];
		EXPECT_EQ(assembly.placeOfVertex[13 * row + 12], place);
		const Point mean = (mesh.positions.col(13 * row) + mesh.positions.col(13 * row + 12)) / 2;
		EXPECT_LT((assembly.originalPositions.col(place) - mean).norm(), 1e-15);
	}
	// Lengths are taken after the vertices went to their mean.
	const Eigen::VectorXd lengths = edgeLengths(assembly, assembly.originalPositions);
	EXPECT_GT((lengths - edgeLengths(assembled(mesh), mesh.positions)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(LinkedVertices, JunctionOfSeams) {
	// Above, two squares side by side; below, one rectangle that has a vertex where they meet.
	const Point apex(1, -0.5, 0.35);
	const std::vector<Point> ring = {Point(0, -1, 0), Point(2, -1, 0), 2 * x, x, origin};
	const TriangleMesh mesh =
		together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)), fan(apex, ring));
	const PatchAssembly assembly = assembled(mesh);
	expectCounts(assembly, 3, 6 + 2 + 3, 5 + 5 + 6, 4);
	expectDefects(assembly, x, {0, 0, 0});
	expectDefects(assembly, x + y, {0, 0});
	expectDefects(assembly, origin, {0, 0});
	expectDefects(assembly, 2 * x, {0, 0});
	expectDefects(assembly, apex, {fanDefect(apex, ring)});
	expectDefects(assembly, {0.5, 0.5, 0.2}, {pyramidDefect(0.2)});
	expectDefects(assembly, {1.5, 0.5, 0.9}, {pyramidDefect(0.9)});

	// With shared vertices no edge has a third face: all one patch, and the junction lies inside it.
	const PatchAssembly one = assembled(shared(mesh));
	expectCounts(one, 1, 11, 11, 0);
	expectDefects(one, x,
				  {fanDefect(x, {origin, apex, 2 * x, Point(1.5, 0.5, 0.9), x + y, Point(0.5, 0.5, 0.2)})});
}

TEST(LinkedVertices, JunctionWithoutAVertexBelowLinksTheTwoAbove) {
	const TriangleMesh mesh = together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)),
									   pyramid({0, -2, 0}, 2 * x, 2 * y, 0.4));
	const PatchAssembly assembly = assembled(mesh);
	expectCounts(assembly, 3, 6 + 2 + 3, 15, 4);
	expectDefects(assembly, x, {0, 0});
}

TEST(LinkedVertices, WeldDistanceIsInclusiveAndTransitive) {
	// Three pyramids, corner to corner at steps of a sixteenth, which numbers hold exactly.
	const double step = 0.0625;
	TriangleMesh chain = pyramid(origin, -x, y, 0.3);
	chain = together(chain, pyramid(step * x, x, -y, 0.4));
	chain = together(chain, pyramid(2 * step * x, x, z, 0.5));
	EXPECT_EQ(assembled(chain).assemblingPlaceCount(), 0);
	EXPECT_EQ(assembled(chain, welding(0.999 * step)).assemblingPlaceCount(), 0);
	// The other corners of the bases: those at x = 1 + step and 1 + 2 step are linked too.
	const PatchAssembly assembly = assembled(chain, welding(step));
	expectCounts(assembly, 3, 15 - 2 - 1, 15, 2);
	EXPECT_EQ(assembly.placeOfVertex[0], assembly.placeOfVertex[5]);
	EXPECT_EQ(assembly.placeOfVertex[5], assembly.placeOfVertex[10]);
	const int place = assembly.placeOfVertex[0];
	EXPECT_LT((assembly.originalPositions.col(place) - step * x).norm(), 1e-15);

	// Without the link in the middle the ends are too far apart.
	const TriangleMesh ends = together(pyramid(origin, -x, y, 0.3), pyramid(2 * step * x, x, z, 0.5));
	EXPECT_EQ(assembled(ends, welding(1.9 * step)).assemblingPlaceCount(), 0);
	EXPECT_EQ(assembled(ends, welding(2 * step)).assemblingPlaceCount(), 1);
}

TEST(LinkedVertices, WeldingMeasuresG) {
	// Two pyramids a little apart: each apex sees its base where the welded corners went.
	const double gap = 0.02;
	const PatchAssembly assembly = assembled(
		together(pyramid(origin, x, y, 0.4), pyramid((1 + gap) * x, x, y, 0.4)), welding(gap * 1.001));
	const double seam = 1 + gap / 2;
	expectCounts(assembly, 2, 8, 10, 2);
	for (const double along : {0.5, 1.5 + gap}) {
		const Point apex(along, 0.5, 0.4);
		const double outer = along < 1 ? 0 : 2 + gap;
		expectDefects(assembly, apex,
					  {fanDefect(apex, {Point(outer, 0, 0), Point(seam, 0, 0), Point(seam, 1, 0),
										Point(outer, 1, 0)})});
	}
}

TEST(LinkedVertices, EqualCoordinatesAreEqualWhateverTheSignOfZero) {
	TriangleMesh mesh = together(pyramid(origin, x, y, 0.3), pyramid(origin, -x, -y, 0.3));
	mesh.positions.col(5) << -0.0, 0.0, -0.0;
	EXPECT_EQ(assembled(mesh).assemblingPlaceCount(), 1);
}

TEST(LinkedVertices, WeldingFarFromTheOriginAndAtAnyScale) {
	const TriangleMesh mesh = grid(13, 6, sleeve(1e-3));
	for (const double scale : {1e-8, 1.0, 1e8}) {
		TriangleMesh other = mesh;
		other.positions = moved(mesh.positions, scale, scale * Point(-300, 200, 100));
		EXPECT_EQ(assembled(other, welding(1.1e-3 * scale)).assemblingPlaceCount(), 6);
		EXPECT_EQ(assembled(other, welding(0.9e-3 * scale)).assemblingPlaceCount(), 0);
	}
}

TEST(LinkedVertices, WeldDistanceThatCollapsesATriangleIsRefused) {
	// An edge shorter than the distance.
	const TriangleMesh mesh = pyramid(origin, x, y, 0.3);
	EXPECT_NE(refusal<DegenerateTriangle>(mesh, welding(0.8)).find("4 triangles"), std::string::npos);
	// No edge is, but stepping stones on the way link two corners of one triangle.
	TriangleMesh chain = mesh;
	for (const double step : {0.3, 0.6})
		chain = together(chain, pyramid(step * x, -y, -z, 0.5));
	EXPECT_NO_THROW(assembled(chain, welding(0.2)));
	EXPECT_NE(refusal<DegenerateTriangle>(chain, welding(0.45)).find("1 triangle:"), std::string::npos)
		<< refusal<DegenerateTriangle>(chain, welding(0.45));
	// Corners keep apart, but their means lie on a line.
	TriangleMesh flattened = fan({0.5, 0.05, 0}, {origin, x, Point(0.5, 1, 0)});
	flattened =
		together(flattened, fan({0.5, -0.05, 0}, {Point(0.2, -1, 0), Point(0.8, -1, 0), Point(0.5, -2, 0)}));
	EXPECT_EQ(refusal<DegenerateTriangle>(flattened, welding(0.101)).rfind("1 face has no area", 0), 0u);
}

} // namespace
} // namespace developable::test
