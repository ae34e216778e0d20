// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/mesh.h"

#include "developable/geometry/geometry.h"
#include "developable/vcg_mesh/vcg_mesh.h"
#include "developable/penalty/penalty_method.h"
#include "support/shapes.h"
#include "support/vcg_meshes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using Point = Eigen::Vector3d;

double angleAt(const Point& apex, const Point& a, const Point& b) {
	return std::acos((a - apex).normalized().dot((b - apex).normalized()));
}

/// Angle defect of a vertex with these neighbours round it.
double fanDefect(const Point& apex, const std::vector<Point>& ring) {
	double defect = 2 * pi;
	for (std::size_t i = 0; i < ring.size(); ++i)
		defect -= angleAt(apex, ring[i], ring[(i + 1) % ring.size()]);
	return defect;
}

/// A cone of triangles: the ring's points are vertices 0 to n - 1, the apex is vertex n.
TriangleMesh fan(const Point& apex, const std::vector<Point>& ring) {
	const int count = static_cast<int>(ring.size());
	Positions positions(3, count + 1);
	Eigen::Matrix3Xi triangles(3, count);
	for (int i = 0; i < count; ++i) {
		positions.col(i) = ring[i];
		triangles.col(i) << i, (i + 1) % count, count;
	}
	positions.col(count) = apex;
	return makeMesh(positions, triangles);
}

/// A square pyramid without its base, on the square from a corner along two sides, its apex a height above.
TriangleMesh pyramid(const Point& corner, const Point& side, const Point& other, double height) {
	const Point apex = corner + (side + other) / 2 + height * side.cross(other).normalized();
	return fan(apex, {corner, corner + side, corner + side + other, corner + other});
}

/// g at the apex of a pyramid over the unit square: the cosine of each of its four angles is h²/(½ + h²).
double pyramidDefect(double height) {
	return 2 * pi - 4 * std::acos(height * height / (0.5 + height * height));
}

/// The same mesh with one vertex for those that coincide.
TriangleMesh shared(const TriangleMesh& mesh) {
	std::map<std::array<double, 3>, int> numbers;
	std::vector<int> number;
	for (const auto& p : mesh.positions.colwise())
		number.push_back(
			numbers.emplace(std::array<double, 3>{p[0], p[1], p[2]}, int(numbers.size())).first->second);
	Positions positions(3, numbers.size());
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		positions.col(number[vertex]) = mesh.positions.col(vertex);
	Eigen::Matrix3Xi triangles = mesh.triangles;
	for (int& vertex : triangles.reshaped())
		vertex = number[vertex];
	return makeMesh(positions, triangles);
}

/// The place of a point, or -1.
int placeAt(const PatchAssembly& assembly, const Point& point) {
	for (int place = 0; place < assembly.placeCount(); ++place)
		if ((assembly.originalPositions.col(place) - point).norm() < 1e-12)
			return place;
	return -1;
}

/// g of every copy at a place, inside its patch or not, ascending.
std::vector<double> defectsAt(const PatchAssembly& assembly, int place) {
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	std::vector<double> result;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.placeOfCopy[copy] == place)
			result.push_back(defects[copy]);
	std::sort(result.begin(), result.end());
	return result;
}

void expectDefects(const PatchAssembly& assembly, const Point& point, std::vector<double> expected) {
	const int place = placeAt(assembly, point);
	ASSERT_GE(place, 0);
	const std::vector<double> defects = defectsAt(assembly, place);
	std::sort(expected.begin(), expected.end());
	ASSERT_EQ(defects.size(), expected.size()) << "at " << point.transpose();
	for (std::size_t i = 0; i < expected.size(); ++i)
		EXPECT_NEAR(defects[i], expected[i], 1e-13) << "at " << point.transpose();
	EXPECT_EQ(assembly.placeAssembling[place], expected.size() > 1);
}

void expectCounts(const PatchAssembly& assembly, int patches, int places, int copies, int assembling) {
	EXPECT_EQ(assembly.patchCount(), patches);
	EXPECT_EQ(assembly.placeCount(), places);
	EXPECT_EQ(assembly.copyCount(), copies);
	EXPECT_EQ(assembly.assemblingPlaceCount(), assembling);
}

/// What an exception of the given type says.
template <class Exception, class Function>
std::string messageOf(const Function& function) {
	try {
		function();
	} catch (const Exception& exception) {
		return exception.what();
	}
	ADD_FAILURE() << "nothing was thrown";
	return {};
}

template <class Exception>
std::string refusal(const TriangleMesh& mesh, const PatchOptions& options = {}) {
	return messageOf<Exception>([&] { assemblePatches(mesh, options); });
}

PatchOptions welding(double distance) {
	PatchOptions options;
	options.weldDistance = distance;
	return options;
}

const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), origin(0, 0, 0);

TEST(PatchAssembly, VertexInsideOnePatchAndOnAnothersBoundary) {
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

TEST(PatchAssembly, EdgeInsideOnePatchAndOnAnothersBoundary) {
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

TEST(PatchAssembly, ThreePatchesOnOneEdge) {
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

TEST(PatchAssembly, FourFacesOnOneEdgeSeparateFourPatches) {
	Positions positions(3, 6);
	positions << origin, z, x, y, -x, -y;
	Eigen::Matrix3Xi triangles(3, 4);
	triangles << 0, 0, 0, 0, 1, 1, 1, 1, 2, 3, 4, 5;
	const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
	expectCounts(assembly, 4, 6, 12, 2);
	expectDefects(assembly, origin, {0, 0, 0, 0});
}

TEST(PatchAssembly, BowTieBetweenTwoPatches) {
	const TriangleMesh both = together(pyramid(origin, x, y, 0.3), pyramid(origin, -x, -y, 0.6));
	for (const TriangleMesh& mesh : {both, shared(both)}) {
		const PatchAssembly assembly = assembled(mesh);
		expectCounts(assembly, 2, 9, 10, 1);
		expectDefects(assembly, origin, {0, 0});
		expectDefects(assembly, {0.5, 0.5, 0.3}, {pyramidDefect(0.3)});
		expectDefects(assembly, {-0.5, -0.5, 0.6}, {pyramidDefect(0.6)});
	}
}

TEST(PatchAssembly, BowTieOfTwoInteriorFans) {
	// Two pyramids with their apexes at one vertex: interior in both.
	const Point apex(0.5, 0.5, 0.5);
	const TriangleMesh both = together(pyramid(origin, x, y, 0.5), pyramid({0, 0, 0.8}, x, y, -0.3));
	for (const TriangleMesh& mesh : {both, shared(both)}) {
		const PatchAssembly assembly = assembled(mesh);
		expectCounts(assembly, 2, 9, 10, 1);
		expectDefects(assembly, apex, {pyramidDefect(0.5), pyramidDefect(0.3)});
	}
}

TEST(PatchAssembly, BowTieWithinOnePatch) {
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

TEST(PatchAssembly, OppositeOrientationsChangeNoDefect) {
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

/// A barrel of unit height, closed at u = 1 to the last bit but for a gap.
Surface sleeve(double gap) {
	return [gap](double u, double v) -> Point {
		const double radius = 1 + v * (1 - v), angle = u < 1 ? 2 * pi * u : 0;
		return {radius * std::cos(angle), radius * std::sin(angle), u < 1 ? v : v + gap};
	};
}

TEST(PatchAssembly, SleeveSewnToItself) {
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

TEST(PatchAssembly, SleeveSewnToItselfAcrossAGap) {
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

TEST(PatchAssembly, JunctionOfSeams) {
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

TEST(PatchAssembly, JunctionWithoutAVertexBelowLinksTheTwoAbove) {
	const TriangleMesh mesh = together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)),
									   pyramid({0, -2, 0}, 2 * x, 2 * y, 0.4));
	const PatchAssembly assembly = assembled(mesh);
	expectCounts(assembly, 3, 6 + 2 + 3, 15, 4);
	expectDefects(assembly, x, {0, 0});
}

TEST(PatchAssembly, MoebiusStripHasOneSideAndItsDefects) {
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
										   assembly.originalPositions.col(t[(corner + 1) % 3]),
										   assembly.originalPositions.col(t[(corner + 2) % 3]));
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		EXPECT_NEAR(defects[copy], assembly.copyInterior[copy] ? expected[assembly.placeOfCopy[copy]] : 0,
					1e-12);
	EXPECT_GT(defects.cwiseAbs().maxCoeff(), 1e-3);

	// Cut along its seam, it has two.
	EXPECT_TRUE(assembled(mesh).patches[0].orientable);
	EXPECT_EQ(assembled(mesh).assemblingPlaceCount(), rows);
}

TEST(PatchAssembly, WeldDistanceIsInclusiveAndTransitive) {
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

TEST(PatchAssembly, WeldingMeasuresG) {
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

TEST(PatchAssembly, EqualCoordinatesAreEqualWhateverTheSignOfZero) {
	TriangleMesh mesh = together(pyramid(origin, x, y, 0.3), pyramid(origin, -x, -y, 0.3));
	mesh.positions.col(5) << -0.0, 0.0, -0.0;
	EXPECT_EQ(assembled(mesh).assemblingPlaceCount(), 1);
}

TEST(PatchAssembly, WeldingFarFromTheOriginAndAtAnyScale) {
	const TriangleMesh mesh = grid(13, 6, sleeve(1e-3));
	for (const double scale : {1e-8, 1.0, 1e8}) {
		TriangleMesh other = mesh;
		other.positions = moved(mesh.positions, scale, scale * Point(-300, 200, 100));
		EXPECT_EQ(assembled(other, welding(1.1e-3 * scale)).assemblingPlaceCount(), 6);
		EXPECT_EQ(assembled(other, welding(0.9e-3 * scale)).assemblingPlaceCount(), 0);
	}
}

TEST(PatchAssembly, WeldDistanceThatCollapsesATriangleIsRefused) {
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

TEST(PatchAssembly, WeldDistanceOutOfRangeIsRefused) {
	const TriangleMesh mesh = pyramid(origin, x, y, 0.3);
	for (const double distance : {-1e-9, std::nan(""), std::numeric_limits<double>::infinity()})
		EXPECT_NE(refusal<InvalidParameter>(mesh, welding(distance)).find("weld distance"),
				  std::string::npos);
}

/// Two pyramids on a common edge and one apart; the first selected by one of its faces.
TriangleMesh oneSelectedOfThree() {
	TriangleMesh mesh = together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)),
								 pyramid(Point(7, 0, 0), x, y, 0.4));
	mesh.triangleSelected[2] = 1;
	return mesh;
}

PatchOptions selectedOnly(double weldDistance = 0) {
	PatchOptions options = welding(weldDistance);
	options.onlySelected = true;
	return options;
}

TEST(PatchAssembly, OnlySelectedKeepsTheSelectedPatchesAndHoldsTheirNeighbours) {
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

TEST(PatchAssembly, OnlySelectedLetsWeldedVerticesComeToThoseThatHoldStill) {
	TriangleMesh mesh = oneSelectedOfThree();
	mesh.positions.middleCols(5, 5).row(2).array() += 0.01; // the neighbour
	const PatchAssembly assembly = assembled(mesh, selectedOnly(0.011));
	for (const int vertex : {1, 2})
		EXPECT_EQ(assembly.originalPositions.col(assembly.placeOfVertex[vertex]),
				  mesh.positions.col(vertex == 1 ? 5 : 8));
}

TEST(PatchAssembly, OnlySelectedWithNothingSelectedIsRefused) {
	EXPECT_NE(refusal<EmptyMesh>(pyramid(origin, x, y, 0.3), selectedOnly()).find("No face is selected"),
			  std::string::npos);
}

TEST(PatchAssembly, FixBoundaryHoldsEveryPlaceThatIsOnSomeBoundary) {
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

TEST(PatchAssembly, FixSelectedHoldsAllThatIsLinkedToASelectedVertex) {
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

TEST(PatchAssembly, ClosedPatchesAreCounted) {
	TriangleMesh mesh = together(octahedron(), pyramid(Point(5, 0, 0), x, y, 0.3));
	EXPECT_NO_THROW(requireOpenPatches(assembled(pyramid(origin, x, y, 0.3))));
	EXPECT_EQ(messageOf<ClosedPatch>([&] { requireOpenPatches(assembled(mesh)); }).rfind("1 of 2 patches", 0),
			  0u);
	TriangleMesh ball = octahedron();
	ball.positions.colwise() += Point(0, 9, 0);
	mesh = together(mesh, ball);
	const std::string message = messageOf<ClosedPatch>([&] { requireOpenPatches(assembled(mesh)); });
	EXPECT_EQ(message.rfind("2 of 3 patches", 0), 0u) << message;
	EXPECT_NE(message.find("cut"), std::string::npos);
	EXPECT_NE(message.find("seams"), std::string::npos);
	// Only the patches that are worked on count.
	mesh.triangleSelected[8] = 1; // of the pyramid
	EXPECT_NO_THROW(requireOpenPatches(assembled(mesh, selectedOnly())));
}

TEST(PatchAssembly, ClosedPatchesAddUpToTheirEulerCharacteristic) {
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

TEST(PatchAssembly, SeamsGivenByLabels) {
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

TEST(PatchAssembly, SeamThatEndsInsideAPatchIsASlit) {
	// Labels differ above and below the middle row, from the middle to the right edge; the sheet is bent
	// there.
	TriangleMesh mesh = grid(5, 5, saddle);
	mesh.cornerLabel.resize(3 * mesh.triangleCount());
	for (int corner = 0; corner < 3 * mesh.triangleCount(); ++corner) {
		const int vertex = mesh.triangles(corner % 3, corner / 3), cellRow = corner / 6 / 4;
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

TEST(PatchAssembly, CoordinateThatIsNoNumberIsCounted) {
	TriangleMesh mesh = grid(4, 4, flatSheet);
	mesh.positions(1, 3) = std::nan("");
	EXPECT_EQ(refusal<InvalidCoordinate>(mesh).rfind("1 vertex has", 0), 0u);
	mesh.positions(0, 7) = std::numeric_limits<double>::infinity();
	mesh.positions(1, 7) = std::nan("");
	EXPECT_EQ(refusal<InvalidCoordinate>(mesh).rfind("2 vertices have", 0), 0u);
}

template <class MeshType>
class PatchAssemblyOfAMesh : public testing::Test {
protected:
	using Scalar = typename MeshType::ScalarType;

	static constexpr bool isFloat = sizeof(Scalar) == 4;

	Positions coordinates() const { return readTriangles(mesh).positions; }

	MeshType mesh;
};

using MeshTypes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(PatchAssemblyOfAMesh, MeshTypes);

TYPED_TEST(PatchAssemblyOfAMesh, FaceHasNoAreaBelowItsScalarsOwnThreshold) {
	const double threshold = this->isFloat ? 1e-6 : 1e-12;
	for (const double factor : {0.5, 2.0}) {
		fill(this->mesh, fan({0.5, factor * threshold, 0}, {origin, x, y}));
		if (factor < 1) {
			EXPECT_EQ(messageOf<DegenerateTriangle>([this] {
						  readPatches(this->mesh);
					  }).rfind("1 face has no area", 0),
					  0u);
		} else {
			EXPECT_NO_THROW(readPatches(this->mesh));
		}
	}
}

TYPED_TEST(PatchAssemblyOfAMesh, WritesOnlyTheVerticesWorkedOn) {
	using Allocator = vcg::tri::Allocator<TypeParam>;
	fill(this->mesh, oneSelectedOfThree());
	this->mesh.face[2].SetS();
	Allocator::AddVertex(this->mesh, typename TypeParam::CoordType(4, 5, 6)); // belongs to nothing
	Allocator::AddVertex(this->mesh, typename TypeParam::CoordType(1, 2, 3));
	Allocator::DeleteVertex(this->mesh, this->mesh.vert.back());
	const Positions before = this->coordinates();
	const PatchAssembly assembly = readPatches(this->mesh, selectedOnly());
	writePositions(this->mesh, assembly, Positions::Constant(3, assembly.placeCount(), 77));
	const Positions after = this->coordinates();
	for (int vertex = 0; vertex < before.cols(); ++vertex) {
		if (vertex < 5) {
			EXPECT_EQ(after.col(vertex), Point::Constant(77));
		} else {
			EXPECT_EQ(after.col(vertex), before.col(vertex));
		}
	}
	EXPECT_EQ(this->mesh.vert[16].cP()[2], 3);
}

TYPED_TEST(PatchAssemblyOfAMesh, DeletedFaceOpensAClosedPatch) {
	fill(this->mesh, octahedron());
	EXPECT_THROW(requireOpenPatches(readPatches(this->mesh)), ClosedPatch);
	vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face[0]);
	const PatchAssembly assembly = readPatches(this->mesh);
	EXPECT_NO_THROW(requireOpenPatches(assembly));
	EXPECT_EQ(assembly.interiorCopyCount(), 3);
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	for (int copy = 0; copy < 6; ++copy)
		EXPECT_NEAR(defects[copy], assembly.copyInterior[copy] ? 2 * pi / 3 : 0, 1e-14);
}

TYPED_TEST(PatchAssemblyOfAMesh, NoSeamOpensInARun) {
	// A sleeve sewn to itself across a gap, with a yoke on its upper rim whose vertices are its own.
	TriangleMesh yoke = grid(13, 3, [](double u, double v) {
		const Point rim = sleeve(0)(u, 1);
		return Point(rim[0] * (1 + 0.3 * v), rim[1] * (1 + 0.3 * v), rim[2] + 0.1 * v * v);
	});
	const TriangleMesh shape = together(grid(13, 6, sleeve(1e-3)), yoke);
	fill(this->mesh, shape);
	const PatchAssembly assembly = readPatches(this->mesh, welding(1.01e-3));
	EXPECT_EQ(assembly.assemblingPlaceCount(), 12 + 5 + 2);
	Positions positions = assembly.originalPositions;
	PenaltyMethodOptions options;
	options.maxIterations = 5;
	penaltyMethod(assembly, positions, options);
	ASSERT_GT((positions - assembly.originalPositions).cwiseAbs().maxCoeff(), 1e-3);
	writePositions(this->mesh, assembly, positions);
	const Positions written = this->coordinates();
	int linked = 0;
	for (int a = 0; a < written.cols(); ++a)
		for (int b = 0; b < a; ++b)
			if ((shape.positions.col(a) - shape.positions.col(b)).norm() < 1.005e-3) {
				EXPECT_EQ(written.col(a), written.col(b));
				++linked;
			}
	EXPECT_GE(linked, 13 + 5 + 3);
}

} // namespace
} // namespace developable::test
