// SPDX-License-Identifier: GPL-3.0-or-later
// What closed forms say of a cut, and what holds of any: topology, coincidence, order, stop.
#include "developable/panels/cut_into_panels.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <sched.h>
#include <set>

namespace developable::test {
namespace {

Positions verticesOf(const CutMesh& cut, const TriangleMesh& mesh) {
	Positions positions(3, cut.verticesBefore + int(cut.added.size()));
	for (int vertex = 0; vertex < positions.cols(); ++vertex) {
		const VertexOrigin origin = cut.originOf(vertex);
		positions.col(vertex) = (1 - origin.share) * mesh.positions.col(origin.first) +
								origin.share * mesh.positions.col(origin.second);
	}
	return positions;
}

PatchAssembly assemblyOf(const CutMesh& cut, const TriangleMesh& mesh) {
	return assembled(makeMesh(verticesOf(cut, mesh), cut.triangles));
}

/// The unit cube, each face a grid of cells x cells squares with a diagonal.
TriangleMesh cube(int cells) {
	std::map<std::array<int, 3>, int> numbers;
	std::vector<Eigen::Vector3d> points;
	std::vector<Eigen::Vector3i> triangles;
	const auto vertex = [&](const Eigen::Vector3i& at) {
		const auto [found, isNew] =
			numbers.emplace(std::array<int, 3>{at[0], at[1], at[2]}, int(points.size()));
		if (isNew)
			points.push_back(at.cast<double>() / cells);
		return found->second;
	};
	for (int axis = 0; axis < 3; ++axis)
		for (const int side : {0, cells})
			for (int i = 0; i < cells; ++i)
				for (int j = 0; j < cells; ++j) {
					const auto at = [&](int u, int v) {
						Eigen::Vector3i place;
						place[axis] = side;
						place[(axis + 1) % 3] = side == 0 ? v : u; // outwards on both sides
						place[(axis + 2) % 3] = side == 0 ? u : v;
						return vertex(place);
					};
					triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
					triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
				}
	Positions positions(3, points.size());
	for (std::size_t i = 0; i < points.size(); ++i)
		positions.col(Eigen::Index(i)) = points[i];
	Eigen::Matrix3Xi faces(3, triangles.size());
	for (std::size_t i = 0; i < triangles.size(); ++i)
		faces.col(Eigen::Index(i)) = triangles[i];
	return makeMesh(positions, faces);
}

/// A cone over a polygon with so many corners, open below; apex last.
TriangleMesh cone(int corners, int rings, double height) {
	Positions positions(3, corners * rings + 1);
	Eigen::Matrix3Xi triangles(3, corners * (2 * rings - 1));
	int next = 0;
	const auto at = [&](int ring, int corner) { return ring * corners + corner % corners; };
	for (int ring = 0; ring < rings; ++ring)
		for (int corner = 0; corner < corners; ++corner) {
			const double radius = 1 - double(ring) / rings, angle = 2 * pi * corner / corners;
			positions.col(at(ring, corner)) << radius * std::cos(angle), radius * std::sin(angle),
				height * (1 - radius);
			if (ring + 1 < rings) {
				triangles.col(next++) << at(ring, corner), at(ring, corner + 1), at(ring + 1, corner + 1);
				triangles.col(next++) << at(ring, corner), at(ring + 1, corner + 1), at(ring + 1, corner);
			} else {
				triangles.col(next++) << at(ring, corner), at(ring, corner + 1), corners * rings;
			}
		}
	positions.col(corners * rings) << 0, 0, height;
	return makeMesh(positions, triangles);
}

/// Radius 1, height 2, caps of triangles round their middles.
TriangleMesh cappedCylinder(int corners, int rows) {
	Positions positions(3, corners * (rows + 1) + 2);
	Eigen::Matrix3Xi triangles(3, 2 * corners * (rows + 1));
	const int bottom = corners * (rows + 1), top = bottom + 1;
	positions.col(bottom) << 0, 0, 0;
	positions.col(top) << 0, 0, 2;
	int next = 0;
	for (int corner = 0; corner < corners; ++corner) {
		const double angle = 2 * pi * corner / corners;
		const auto at = [&](int row, int beside) { return row * corners + (corner + beside) % corners; };
		for (int row = 0; row <= rows; ++row)
			positions.col(at(row, 0)) << std::cos(angle), std::sin(angle), 2.0 * row / rows;
		for (int row = 0; row < rows; ++row) {
			triangles.col(next++) << at(row, 0), at(row, 1), at(row + 1, 1);
			triangles.col(next++) << at(row, 0), at(row + 1, 1), at(row + 1, 0);
		}
		triangles.col(next++) << at(0, 1), at(0, 0), bottom;
		triangles.col(next++) << at(rows, 0), at(rows, 1), top;
	}
	return makeMesh(positions, triangles);
}

/// Every patch a disk; none but the seams' vertices doubled.
void expectDisks(const PatchAssembly& assembly) {
	for (const Patch& patch : assembly.patches) {
		EXPECT_EQ(patch.eulerCharacteristic(), 1);
		EXPECT_TRUE(patch.orientable);
		EXPECT_FALSE(patch.closed());
	}
}

TEST(CutIntoPanels, leavesWhatIsDevelopableAsItIs) {
	for (const Surface& surface : {Surface(flatSheet), Surface(quarterCylinder), Surface(coneBand)}) {
		const TriangleMesh mesh = grid(12, 9, surface);
		const CutResult cut = cutIntoPanels(mesh, {}, {});
		EXPECT_EQ(cut.report.status, Status::NothingToDo);
		EXPECT_EQ(cut.report.panels.size(), 1U);
		EXPECT_EQ(cut.report.seamLength, 0);
		EXPECT_TRUE(cut.mesh.added.empty());
		EXPECT_EQ(cut.mesh.triangles, mesh.triangles);
	}
}

TEST(CutIntoPanels, unfoldsACube) {
	const TriangleMesh mesh = cube(4);
	const CutResult cut = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(cut.report.status, Status::Converged);
	EXPECT_LE(cut.report.panels.size(), 6U);
	// A net of one piece has seven of the twelve edges as seams; six faces have all of them.
	const double edges = cut.report.seamLength;
	EXPECT_NEAR(edges, 6 + double(cut.report.panels.size()), 1e-9);
	EXPECT_LT(cut.report.maxDisplacement, 1e-6);
	expectDisks(assemblyOf(cut.mesh, mesh));
}

TEST(CutIntoPanels, slitsAConeToItsApex) {
	const TriangleMesh mesh = cone(24, 6, 1.5);
	const CutResult cut = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(cut.report.status, Status::Converged);
	ASSERT_EQ(cut.report.panels.size(), 1U);
	EXPECT_EQ(cut.report.darts, 1);
	const double slant = std::hypot(1.0, 1.5);
	EXPECT_GE(cut.report.seamLength, slant - 1e-9); // no path from the apex to the border is shorter
	EXPECT_LE(cut.report.seamLength, 1.1 * slant);
	expectDisks(assemblyOf(cut.mesh, mesh));
}

TEST(CutIntoPanels, doubledVerticesCoincideAndPanelsAreDisks) {
	const TriangleMesh mesh = sphere(1, 3);
	const CutResult cut = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(cut.report.status, Status::Converged);
	const PatchAssembly assembly = assemblyOf(cut.mesh, mesh);
	EXPECT_EQ(assembly.patchCount(), int(cut.report.panels.size()));
	expectDisks(assembly);
	EXPECT_LE(cut.report.maxDisplacement, 0.02 * boxDiagonal(mesh.positions));
	for (const CutPanel& panel : cut.report.panels) {
		EXPECT_TRUE(panel.developable);
		EXPECT_LE(panel.curvatureAfter, 1e-4);
	}
	// Sewn together again it is the closed surface: each place of a border is on as many sides as there are.
	std::map<std::pair<int, int>, int> sides;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
		++sides[std::minmax(assembly.placeAt(h), assembly.placeAt(nextCorner(h)))];
	for (const auto& [ends, count] : sides)
		EXPECT_EQ(count, 2);
	double area = 0;
	for (const CutPanel& panel : cut.report.panels)
		area += panel.area;
	double before = 0;
	for (const auto& t : mesh.triangles.colwise())
		before += (mesh.positions.col(t[1]) - mesh.positions.col(t[0]))
					  .cross(mesh.positions.col(t[2]) - mesh.positions.col(t[0]))
					  .norm() /
				  2;
	EXPECT_NEAR(area, before, 1e-9);
}

TEST(CutIntoPanels, isTheSameOnEveryRun) {
	const TriangleMesh mesh = grid(9, 9, steepBump);
	const CutResult first = cutIntoPanels(mesh, {}, {}), second = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
	EXPECT_EQ(first.mesh.panel, second.mesh.panel);
	EXPECT_EQ(first.report.maxDisplacement, second.report.maxDisplacement);
}

/// The processor that this thread is on, for as long as it lives.
class OnOneProcessor {
public:
	OnOneProcessor() {
		sched_getaffinity(0, sizeof before_, &before_);
		cpu_set_t one;
		CPU_ZERO(&one);
		CPU_SET(sched_getcpu(), &one);
		sched_setaffinity(0, sizeof one, &one);
	}
	~OnOneProcessor() { sched_setaffinity(0, sizeof before_, &before_); }
	OnOneProcessor(const OnOneProcessor&) = delete;
	OnOneProcessor& operator=(const OnOneProcessor&) = delete;

private:
	cpu_set_t before_;
};

TEST(CutIntoPanels, isTheSameOnAnyNumberOfProcessors) {
	const TriangleMesh mesh = sphere(1, 3);
	const CutResult many = cutIntoPanels(mesh, {}, {});
	const OnOneProcessor one;
	ASSERT_EQ(availableThreads(), 1);
	const CutResult single = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(many.mesh.triangles, single.mesh.triangles);
	EXPECT_EQ(many.mesh.panel, single.mesh.panel);
	EXPECT_EQ(many.report.seamLength, single.report.seamLength);
	EXPECT_EQ(many.report.maxDisplacement, single.report.maxDisplacement);
}

TEST(CutIntoPanels, unrollsACappedCylinder) {
	const TriangleMesh mesh = cappedCylinder(24, 6);
	const CutResult cut = cutIntoPanels(mesh, {}, {});
	EXPECT_EQ(cut.report.status, Status::Converged);
	EXPECT_LE(cut.report.panels.size(), 3U);
	EXPECT_LT(cut.report.maxDisplacement, 0.02 * boxDiagonal(mesh.positions));
	expectDisks(assemblyOf(cut.mesh, mesh));
}

TEST(CutIntoPanels, keepsSelectedTrianglesWhole) {
	TriangleMesh mesh = cube(4);
	const auto isOnTop = [&](int t) {
		return (mesh.positions(2, mesh.triangles(0, t)) + mesh.positions(2, mesh.triangles(1, t)) +
				mesh.positions(2, mesh.triangles(2, t))) > 3 - 1e-9;
	};
	for (int t = 0; t < mesh.triangleCount(); ++t)
		mesh.triangleSelected[t] = isOnTop(t);
	CutOptions options;
	options.keepSelected = true;
	const CutResult cut = cutIntoPanels(mesh, {}, options);
	std::set<int> panels;
	std::map<int, int> parts;
	for (std::size_t t = 0; t < cut.mesh.face.size(); ++t) {
		++parts[cut.mesh.face[t]];
		if (isOnTop(cut.mesh.face[t]))
			panels.insert(cut.mesh.panel[t]);
	}
	EXPECT_EQ(panels.size(), 1U);
	for (const auto& [face, count] : parts)
		EXPECT_TRUE(count == 1 || !isOnTop(face));
}

TEST(CutIntoPanels, stopsWhenAsked) {
	int calls = 0;
	const CutResult cut =
		cutIntoPanels(sphere(1, 3), {}, {}, [&](double, const std::string&) { return ++calls < 5; });
	EXPECT_EQ(cut.report.status, Status::Stopped);
	EXPECT_EQ(cut.mesh.triangles.cols(), 0);
}

TEST(CutIntoPanels, saysWhatIsWrongWithOptions) {
	CutOptions options;
	options.maxPanels = -1;
	EXPECT_THROW(cutIntoPanels(octahedron(), {}, options), InvalidParameter);
	options = {};
	options.creaseAngle = 181;
	EXPECT_THROW(cutIntoPanels(octahedron(), {}, options), InvalidParameter);
	options = {};
	options.maxDisplacement = std::numeric_limits<double>::quiet_NaN();
	EXPECT_THROW(cutIntoPanels(octahedron(), {}, options), InvalidParameter);
}

} // namespace
} // namespace developable::test
