// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/polygons/polygon_triangulation.h"

#include "contours.h"
#include "support/shapes.h"
#include "support/vcg_meshes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using Loop = std::vector<int>;

template <class MeshType>
class PolygonsOfAMesh : public ::testing::Test {
protected:
	void addVertices(const Positions& positions) {
		TriangleMesh shape;
		shape.positions = positions;
		shape.triangles.resize(3, 0);
		fill(mesh, shape);
	}

	/// Its corners get texture coordinates of their own, by vertex and polygon.
	typename MeshType::FaceType& addTriangle(int a, int b, int c, int polygon = 0) {
		vcg::tri::Allocator<MeshType>::AddFace(mesh, a, b, c);
		auto& face = mesh.face.back();
		for (int corner = 0; corner < 3; ++corner) {
			face.WT(corner).U() = float(vcg::tri::Index(mesh, face.V(corner)));
			face.WT(corner).V() = float(polygon);
			face.WT(corner).N() = short(polygon);
		}
		face.C() = vcg::Color4b(10 * polygon, 1, 2, 255);
		face.Q() = float(polygon);
		return face;
	}

	/// As hosts load it from PLY: a fan from the first corner, faux edges inside.
	void addPolygon(const Loop& loop, int polygon = 0) {
		const int count = static_cast<int>(loop.size());
		for (int i = 1; i + 1 < count; ++i) {
			auto& face = addTriangle(loop[0], loop[i], loop[i + 1], polygon);
			if (i > 1)
				face.SetF(0);
			if (i + 2 < count)
				face.SetF(2);
		}
	}

	/// The faces, each from its smallest vertex on, each corner doubled, odd where a faux edge begins.
	std::vector<std::array<int, 3>> faces() const {
		std::vector<std::array<int, 3>> result;
		for (const auto& face : mesh.face) {
			if (face.IsD())
				continue;
			std::array<int, 3> corners;
			for (int i = 0; i < 3; ++i)
				corners[i] = static_cast<int>(vcg::tri::Index(mesh, face.cV(i))) * 2 + face.IsF(i);
			std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
			result.push_back(corners);
		}
		return result;
	}

	/// The sides of all faces that are not faux, in their direction.
	Edges contourSides() const {
		Edges result;
		for (const auto& face : mesh.face)
			for (int i = 0; i < 3; ++i)
				if (!face.IsF(i))
					result.emplace(vcg::tri::Index(mesh, face.cV(i)),
								   vcg::tri::Index(mesh, face.cV((i + 1) % 3)));
		return result;
	}

	/// The least area of a face, in the plane z = 0.
	double leastArea() const {
		const TriangleMesh shape = readTriangles(mesh);
		const Contour flat = shape.positions.topRows<2>();
		double least = std::numeric_limits<double>::infinity();
		for (const auto& t : shape.triangles.colwise())
			least = std::min(least, area(flat.col(t[0]), flat.col(t[1]), flat.col(t[2])));
		return least;
	}

	/// Every faux edge is one from both sides, and no edge has more than two faces.
	void expectProperEdges() const {
		std::map<std::pair<int, int>, std::vector<bool>> faux;
		for (const auto& face : mesh.face)
			for (int i = 0; i < 3; ++i) {
				const int a = int(vcg::tri::Index(mesh, face.cV(i)));
				const int b = int(vcg::tri::Index(mesh, face.cV((i + 1) % 3)));
				faux[std::minmax(a, b)].push_back(face.IsF(i));
			}
		for (const auto& [edge, sides] : faux) {
			EXPECT_LE(sides.size(), 2u);
			EXPECT_EQ(sides.front(), sides.back());
			EXPECT_TRUE(!sides.front() || sides.size() == 2);
		}
	}

	void expectReport(int polygons, int edgesChanged, int skipped) {
		const PolygonReport report = triangulatePolygons(mesh);
		EXPECT_EQ(report.polygons, polygons);
		EXPECT_EQ(report.edgesChanged, edgesChanged);
		EXPECT_EQ(report.skipped, skipped);
	}

	/// The polygons are found, counted as skipped, and nothing is written.
	void expectAllSkipped(int polygons) {
		const auto before = faces();
		expectReport(polygons, 0, polygons);
		EXPECT_EQ(faces(), before);
	}

	MeshType mesh;
};

using MeshTypes = ::testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(PolygonsOfAMesh, MeshTypes, );

TYPED_TEST(PolygonsOfAMesh, QuadIsFlippedOnceAndThenStays) {
	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	const Edges sides = this->contourSides();
	this->expectReport(1, 1, 0);
	EXPECT_EQ(this->contourSides(), sides);
	this->expectProperEdges();
	const auto after = this->faces();
	this->expectReport(1, 0, 0);
	EXPECT_EQ(this->faces(), after);
}

TYPED_TEST(PolygonsOfAMesh, CornersOnACircleKeepTheirDiagonals) {
	const TriangleMesh sheet = grid(7, 5, flatSheet);
	for (const auto& [scale, shift] : {std::make_pair(1.0, 0.0), std::make_pair(0.037, 3.0)}) {
		this->addVertices(moved(sheet.positions, scale, {shift, 2 * shift, -shift}));
		for (int row = 0; row < 4; ++row)
			for (int column = 0; column < 6; ++column) {
				const int a = 7 * row + column;
				this->addPolygon((row + column) % 2 ? Loop{a, a + 1, a + 8, a + 7}
													: Loop{a + 1, a + 8, a + 7, a});
			}
		const auto before = this->faces();
		this->expectReport(24, 0, 0);
		EXPECT_EQ(this->faces(), before);
	}
}

TYPED_TEST(PolygonsOfAMesh, NonConvexPolygonsFanOutsideBeforeAndFillTheirContourAfter) {
	const Contour contour = comb(5);
	this->addVertices(inSpace(contour));
	Loop loop(contour.cols());
	std::iota(loop.begin(), loop.end(), 0);
	this->addPolygon(loop);
	EXPECT_LT(this->leastArea(), -1);
	const Edges sides = this->contourSides();
	EXPECT_EQ(triangulatePolygons(this->mesh).skipped, 0);
	EXPECT_GT(this->leastArea(), 0);
	EXPECT_EQ(this->contourSides(), sides);
	this->expectProperEdges();
	expectConstrainedDelaunay(contour.cast<typename TypeParam::ScalarType>().template cast<double>(),
							  readTriangles(this->mesh).triangles);
}

TYPED_TEST(PolygonsOfAMesh, NeighboursKeepTheirSharedSidesAndWhatTheyCarry) {
	// Two kites side by side, a pentagon below them, a triangle above, and a deleted face.
	Positions positions(3, 8);
	positions << -2, 0, 2, 0, 4, 6, 4, 2, //
		0, -1, 0, 1, -1, 0, 1, -3,        //
		0, 0, 0, 0, 0, 0, 0, 0;
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3}, 1);
	this->addPolygon({2, 4, 5, 6}, 2);
	this->addPolygon({2, 6, 3}, 3);
	this->addPolygon({1, 7, 4, 2}, 4);
	this->addTriangle(0, 7, 1);
	vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face.back());
	this->mesh.face[0].SetB(0);         // the side from 0 to 1
	this->mesh.face[1].SetFaceEdgeS(2); // the side from 3 to 0
	this->mesh.face[2].SetS();
	const Edges sides = this->contourSides();
	this->expectReport(3, 3, 0);
	EXPECT_EQ(this->contourSides(), sides);
	this->expectProperEdges();
	const std::vector<int> polygonOfFace = {1, 1, 2, 2, 3, 4, 4};
	for (int i = 0; i < 7; ++i) {
		auto& face = this->mesh.face[i];
		EXPECT_EQ(face.Q(), polygonOfFace[i]);
		EXPECT_EQ(face.C()[0], 10 * polygonOfFace[i]);
		EXPECT_EQ(face.IsS(), i == 2);
		for (int corner = 0; corner < 3; ++corner) {
			const int from = int(vcg::tri::Index(this->mesh, face.V(corner)));
			const int to = int(vcg::tri::Index(this->mesh, face.V((corner + 1) % 3)));
			EXPECT_EQ(face.WT(corner).U(), from);
			EXPECT_EQ(face.WT(corner).V(), polygonOfFace[i]);
			EXPECT_EQ(face.WT(corner).N(), polygonOfFace[i]);
			EXPECT_EQ(face.IsB(corner), i < 2 && from == 0 && to == 1);
			EXPECT_EQ(face.IsFaceEdgeS(corner), i < 2 && from == 3 && to == 0);
		}
	}
	EXPECT_TRUE(this->mesh.face[7].IsD());
}

TYPED_TEST(PolygonsOfAMesh, TrianglesThatStayKeepTheirFace) {
	// A pentagon with one bad diagonal: the fan from 0 has the triangle 0 3 4 right and the kite 0 1 2 3
	// wrong.
	Positions positions(3, 5);
	positions << -2, 0, 2, 0, -2, 0, -1, 0, 1, 1.5, 0, 0, 0, 0, 0;
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3, 4});
	this->mesh.face[2].SetV(); // marks the face
	this->expectReport(1, 1, 0);
	for (int i = 0; i < 3; ++i) {
		std::set<int> corners;
		for (int corner = 0; corner < 3; ++corner)
			corners.insert(int(vcg::tri::Index(this->mesh, this->mesh.face[i].V(corner))));
		EXPECT_EQ(this->mesh.face[i].IsV(), i == 2);
		EXPECT_EQ(corners == (std::set<int>{0, 3, 4}), i == 2);
	}
}

TYPED_TEST(PolygonsOfAMesh, ThoseThatCrossThemselvesInProjectionAreLeftAlone) {
	Positions positions(3, 8);
	positions << inSpace(points({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), inSpace(kite);
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3});
	this->addPolygon({4, 5, 6, 7});
	const auto before = this->faces();
	this->expectReport(2, 1, 1);
	const auto after = this->faces();
	EXPECT_TRUE(std::equal(before.begin(), before.begin() + 2, after.begin()));
	EXPECT_NE(after[2], before[2]);
}

TYPED_TEST(PolygonsOfAMesh, PolygonsThatAreNoDisksAreLeftAlone) {
	// A vertex inside: four triangles round it.
	Positions positions(3, 5);
	positions << inSpace(kite), Eigen::Vector3d(0.2, 0, 0);
	this->addVertices(positions);
	for (int i = 0; i < 4; ++i) {
		this->addTriangle(i, (i + 1) % 4, 4);
		this->mesh.face.back().SetF(1);
		this->mesh.face.back().SetF(2);
	}
	this->expectAllSkipped(1);

	// A hole: a square ring, all its edges across faux.
	this->addVertices(inSpace(points({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}})));
	for (int i = 0; i < 4; ++i) {
		const int next = (i + 1) % 4;
		this->addTriangle(i, next, next + 4);
		this->mesh.face.back().SetF(1);
		this->mesh.face.back().SetF(2);
		this->addTriangle(i, next + 4, i + 4);
		this->mesh.face.back().SetF(0);
		this->mesh.face.back().SetF(2);
	}
	this->expectAllSkipped(1);
}

TYPED_TEST(PolygonsOfAMesh, PolygonsThatTheirTrianglesDisagreeOnAreLeftAlone) {
	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	this->mesh.face[1].ClearF(0); // a faux edge from one side only
	this->expectAllSkipped(1);

	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face[1]); // the other half is gone
	this->expectAllSkipped(1);

	this->addVertices(inSpace(kite));
	this->addTriangle(0, 1, 2);
	this->addTriangle(0, 3, 2); // of the opposite orientation
	this->mesh.face[0].SetF(2);
	this->mesh.face[1].SetF(2);
	this->expectAllSkipped(1);

	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	this->mesh.face[1].WT(0).U() += 1; // a texture seam along the diagonal
	this->expectAllSkipped(1);
}

TYPED_TEST(PolygonsOfAMesh, NoEdgeGetsMoreThanTwoFaces) {
	// A third face on the diagonal that would go.
	Positions positions(3, 5);
	positions << inSpace(kite), Eigen::Vector3d(0, 0, 2);
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3});
	this->addPolygon({0, 2, 4});
	this->expectAllSkipped(2);

	// A face on the diagonal that would come.
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3});
	this->addPolygon({1, 3, 4});
	this->expectAllSkipped(1);

	// A cushion of two kites back to back, one of them with the right diagonal: the other can't have it too.
	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	this->addPolygon({3, 2, 1, 0}, 1);
	this->expectReport(2, 0, 1);
}

TYPED_TEST(PolygonsOfAMesh, TwoPolygonsThatWantTheSameDiagonalGetItOnce) {
	// Two sheets over the same four contour vertices, joined at two corners that both would connect.
	Positions positions(3, 6);
	positions << -2, 0, 2, 0, -2, 2, //
		0, -1, 0, 1, 0, 0,           //
		0, 0, 0, 0, 1e-3, 1e-3;
	this->addVertices(positions);
	this->addPolygon({0, 1, 2, 3}, 0);
	this->addPolygon({4, 1, 5, 3}, 1);
	this->expectReport(2, 1, 1);
	this->expectProperEdges();
}

TYPED_TEST(PolygonsOfAMesh, WithoutPolygonsThereIsNothingToDo) {
	fill(this->mesh, grid(4, 4, flatSheet));
	const auto before = this->faces();
	this->expectReport(0, 0, 0);
	EXPECT_EQ(this->faces(), before);
}

TYPED_TEST(PolygonsOfAMesh, BadInputIsRefusedAndLeftAsItWas) {
	EXPECT_THROW(triangulatePolygons(this->mesh), EmptyMesh);
	this->addVertices(inSpace(kite));
	this->addPolygon({0, 1, 2, 3});
	this->mesh.vert[2].P()[1] = std::numeric_limits<typename TypeParam::ScalarType>::quiet_NaN();
	const auto before = this->faces();
	EXPECT_THROW(triangulatePolygons(this->mesh), InvalidCoordinate);
	EXPECT_EQ(this->faces(), before);
}

} // namespace
} // namespace developable::test
