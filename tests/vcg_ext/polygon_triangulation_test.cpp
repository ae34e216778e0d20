// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/polygon_triangulation.h"

#include "support/shapes.h"
#include "support/vcg_meshes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using Contour = Eigen::Matrix2Xd;
using Loop = std::vector<int>;
using Edges = std::set<std::pair<int, int>>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
	return a[0] * b[1] - a[1] * b[0];
}

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
	return cross(b - a, c - a) / 2;
}

double area(const Contour& contour) {
	double sum = 0;
	for (int i = 0; i < contour.cols(); ++i)
		sum += cross(contour.col(i), contour.col((i + 1) % contour.cols())) / 2;
	return sum;
}

/// In the plane z = 0.
Positions inSpace(const Contour& contour) {
	Positions positions = Positions::Zero(3, contour.cols());
	positions.topRows<2>() = contour;
	return positions;
}

Contour points(std::initializer_list<Eigen::Vector2d> list) {
	Contour contour(2, list.size());
	int next = 0;
	for (const auto& point : list)
		contour.col(next++) = point;
	return contour;
}

/// A star-shaped polygon of random radii, many of its corners reflex.
Contour randomPolygon(int corners, unsigned seed) {
	std::mt19937 random(seed);
	Contour contour(2, corners);
	for (int i = 0; i < corners; ++i) {
		const double angle = 2 * pi * i / corners, radius = 0.3 + double(random()) / std::mt19937::max();
		contour.col(i) << radius * std::cos(angle), radius * std::sin(angle);
	}
	return contour;
}

Contour comb(int teeth) {
	Contour contour(2, 3 * teeth + 2);
	int next = 0;
	for (int tooth = 0; tooth < teeth; ++tooth) {
		contour.col(next++) << tooth, 1;
		contour.col(next++) << tooth + 0.4, 1;
		contour.col(next++) << tooth + 0.7, 8;
	}
	contour.col(next++) << teeth, 1;
	contour.col(next++) << 0.5 * teeth, 0;
	return contour.rowwise().reverse(); // counterclockwise
}

/// A band round two turns of a spiral.
Contour spiral(int steps) {
	Contour contour(2, 2 * steps);
	for (int i = 0; i < steps; ++i) {
		const double angle = 4 * pi * i / steps;
		const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
		contour.col(i) = (1.3 + angle / 6) * direction;
		contour.col(2 * steps - 1 - i) = (1 + angle / 6) * direction;
	}
	return contour;
}

/// True when no side of the contour lies between a point within it and a corner.
bool seesEachOther(const Contour& contour, const Eigen::Vector2d& from, int corner) {
	const int count = static_cast<int>(contour.cols());
	const Eigen::Vector2d to = contour.col(corner);
	for (int i = 0; i < count; ++i) {
		const int next = (i + 1) % count;
		if (i == corner || next == corner)
			continue;
		const Eigen::Vector2d a = contour.col(i), b = contour.col(next);
		if (area(from, to, a) * area(from, to, b) <= 0 && area(a, b, from) * area(a, b, to) <= 0)
			return false;
	}
	return true;
}

bool insideCircumcircle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
						const Eigen::Vector2d& point) {
	Eigen::Matrix3d m;
	for (const auto& [row, corner] : {std::make_pair(0, a), std::make_pair(1, b), std::make_pair(2, c)}) {
		const Eigen::Vector2d d = corner - point;
		m.row(row) << d[0], d[1], d.squaredNorm();
	}
	return m.determinant() > 1e-9;
}

/// The definition: the triangles fill the polygon, and no corner inside the circumcircle of a triangle is
/// seen from within that triangle.
void expectConstrainedDelaunay(const Contour& contour, const Eigen::Matrix3Xi& triangles) {
	ASSERT_EQ(triangles.cols(), contour.cols() - 2);
	double sum = 0;
	for (const auto& t : triangles.colwise()) {
		const Eigen::Vector2d a = contour.col(t[0]), b = contour.col(t[1]), c = contour.col(t[2]);
		EXPECT_GT(area(a, b, c), 0);
		sum += area(a, b, c);
		for (int corner = 0; corner < contour.cols(); ++corner) {
			if (corner == t[0] || corner == t[1] || corner == t[2] ||
				!insideCircumcircle(a, b, c, contour.col(corner)))
				continue;
			for (const Eigen::Vector3d& at : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(8, 1, 1),
											  Eigen::Vector3d(1, 8, 1), Eigen::Vector3d(1, 1, 8)}) {
				const Eigen::Vector2d within = (at[0] * a + at[1] * b + at[2] * c) / at.sum();
				EXPECT_FALSE(seesEachOther(contour, within, corner))
					<< "corner " << corner << ", triangle " << t.transpose();
			}
		}
	}
	EXPECT_NEAR(sum, area(contour), 1e-12 * contour.cols() * contour.cwiseAbs().maxCoeff());
}

Edges diagonalsOf(const Eigen::Matrix3Xi& triangles) {
	const auto edges = detail::diagonals(triangles);
	return Edges(edges.begin(), edges.end());
}

/// Four corners in convex position whose Delaunay diagonal is the one between 1 and 3.
const Contour kite = points({{-2, 0}, {0, -1}, {2, 0}, {0, 1}});

TEST(PolygonTriangulation, ConvexQuadGetsItsDelaunayDiagonal) {
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(inSpace(kite))), (Edges{{1, 3}}));
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(inSpace(points({{-1, 0}, {0, -2}, {1, 0}, {0, 2}})))),
			  (Edges{{0, 2}}));
}

TEST(PolygonTriangulation, PolygonsOfManyKindsAreConstrainedDelaunay) {
	std::vector<Contour> contours = {kite, comb(7), spiral(40),
									 points({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}),
									 points({{0, 0}, {1, 0}, {2, 0}, {2, 1.1}, {2, 2}, {0.9, 2}, {0, 2}})};
	for (unsigned seed = 0; seed < 40; ++seed)
		contours.push_back(randomPolygon(4 + seed % 23, seed));
	contours.push_back(randomPolygon(100, 77));
	for (const Contour& contour : contours) {
		ASSERT_GT(area(contour), 0);
		const auto triangles = triangulatePolygon(inSpace(contour));
		ASSERT_TRUE(triangles);
		expectConstrainedDelaunay(contour, *triangles);
	}
}

TEST(PolygonTriangulation, RegularPolygonOfAHundredCorners) {
	Contour contour(2, 100);
	for (int i = 0; i < 100; ++i)
		contour.col(i) << std::cos(2 * pi * i / 100), std::sin(2 * pi * i / 100);
	expectConstrainedDelaunay(contour, *triangulatePolygon(inSpace(contour)));
}

TEST(PolygonTriangulation, TriangleIsItself) {
	const auto triangles = triangulatePolygon(inSpace(points({{0, 0}, {2, 0}, {0, 1}})));
	ASSERT_TRUE(triangles);
	EXPECT_EQ(triangles->cols(), 1);
}

TEST(PolygonTriangulation, ContourThatCrossesOrTouchesItselfIsRefused) {
	for (const Contour& contour :
		 {points({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),                         // crosses
		  points({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}),                 // a corner on a side
		  points({{0, 0}, {1, 0}, {2, -1}, {2, 1}, {1, 0}, {0, 1}}),        // a corner on a corner
		  points({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),                         // twice the same
		  points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}),                         // no area
		  points({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 5}, {1, 2}, {0, 2}}), // a spike
		  points({{1, 1}, {1, 1}, {1, 1}})})
		EXPECT_FALSE(triangulatePolygon(inSpace(contour)));
}

TEST(PolygonTriangulation, DoesNotChangeUnderRigidMotionAndScaling) {
	for (unsigned seed = 0; seed < 10; ++seed) {
		const Contour contour = randomPolygon(17, seed);
		const Edges expected = diagonalsOf(*triangulatePolygon(inSpace(contour)));
		for (const double scale : {1e-30, 1e-4, 1.0, 1e6, 1e30}) {
			const Positions positions = moved(inSpace(contour), scale, scale * Eigen::Vector3d(30, -20, 10));
			EXPECT_EQ(diagonalsOf(*triangulatePolygon(positions)), expected) << scale;
		}
		// Seen from behind.
		const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
		EXPECT_EQ(diagonalsOf(*triangulatePolygon(mirror * moved(inSpace(contour), 1, {1, 2, 3}))), expected);
	}
}

TEST(PolygonTriangulation, CurvedPolygonIsTriangulatedInItsLeastSquaresPlane) {
	// Offsets that add up to nothing along any plane leave the least-squares plane of a parallelogram at z =
	// 0. In space the long diagonal would be the better one: its ends are as far apart as before, the others
	// much farther.
	Positions contour(3, 4);
	contour << 0, 4, 5, 1, 0, 0, 3, 3, 0.8, -0.8, 0.8, -0.8;
	ASSERT_GT((contour.col(2) - contour.col(0)).norm(), (contour.col(3) - contour.col(1)).norm());
	EXPECT_EQ(diagonalsOf(*triangulatePolygon(contour)), (Edges{{1, 3}}));

	// A steep polygon, planar all the same.
	const Contour flat = randomPolygon(12, 5);
	Positions tilted = inSpace(flat);
	tilted.row(2) = 50 * tilted.row(0); // so steep that z has most of it
	const Edges expected = diagonalsOf(*triangulatePolygon(tilted));
	Contour stretched = flat;
	stretched.row(0) *= std::sqrt(1 + 50.0 * 50);
	expectConstrainedDelaunay(stretched, *triangulatePolygon(tilted));
	EXPECT_NE(expected,
			  diagonalsOf(*triangulatePolygon(inSpace(flat)))); // z = 0 would have been the wrong plane
}

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
