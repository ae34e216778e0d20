// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_triangulation.h: the front door of polygons/: polygon faces by constrained Delaunay triangulation
// (Section 3.1).
//
// A polygon is what hosts load a quad or an n-gon as: triangles joined by faux edges, its diagonals. It is
// projected to the least-squares plane of its contour and triangulated there; no vertex is added.
// triangulatePolygons does that to all polygons of a vcg mesh, triangulatePolygon to one by itself. The
// triangulation is CGAL's, whose headers this folder's .cpp files need to compile (Debian: libcgal-dev);
// nothing else of the library needs them, so a build may do without.
#pragma once

#include "polygon_planner.h"
#include "triangulate_polygon.h"

#include "developable/mesh/mesh.h"
#include "developable/vcg_mesh/vcg_mesh.h"

#include <vcg/complex/complex.h>

#include <array>

namespace developable {

/// What became of the polygons of a mesh.
struct PolygonReport {
	int polygons = 0;     ///< of four corners or more, those skipped too
	int edgesChanged = 0; ///< diagonals that were not there before
	/// Polygons left as they were: their contour crosses or touches itself in projection; or they are no
	/// disk (a hole, a vertex inside, a texture seam across, a faux edge that only one side calls so); or a
	/// new diagonal would be an edge that another face has already.
	int skipped = 0;
};

namespace detail {

/// Bits of a vcg face that belong to its edges: the first of three each.
template <class FaceType>
inline constexpr std::array<int, 2> contourBits = {FaceType::BORDER0, FaceType::FACEEDGESEL0};

/// A corner of a vcg face, and the side that begins there.
template <class MeshType>
struct FaceCorner {
	using Face = typename MeshType::FaceType;

	FaceCorner(MeshType& mesh, const TriangleMesh& shape, int halfEdge, bool diagonal) {
		Face& face = mesh.face[shape.face[triangleOf(halfEdge)]];
		const int corner = cornerInTriangle(halfEdge);
		vertex = face.V(corner);
		if (vcg::tri::HasPerWedgeTexCoord(mesh))
			texture = face.cWT(corner);
		for (const int bit : contourBits<Face>)
			bits |= diagonal ? 0 : ((face.Flags() >> corner) & bit);
		bits |= diagonal ? int(Face::FAUX0) : 0;
	}

	void writeTo(MeshType& mesh, Face& face, int corner) const {
		face.V(corner) = vertex;
		if (vcg::tri::HasPerWedgeTexCoord(mesh))
			face.WT(corner) = texture;
		face.Flags() &= ~((Face::BORDER0 | Face::FACEEDGESEL0 | Face::FAUX0) << corner);
		face.Flags() |= bits << corner;
	}

	typename MeshType::VertexPointer vertex;
	typename Face::TexCoordType texture;
	int bits = 0;
};

} // namespace detail

/// Triangulates the polygons of a vcg mesh anew where their triangles are not constrained Delaunay: faces
/// keep their number and what they carry, corners their texture coordinates, edges their flags. Normals, and
/// adjacency if the mesh has it, are the caller's to bring up to date.
///
/// \throws EmptyMesh          when there is no face
/// \throws InvalidCoordinate  when a coordinate is not finite
template <class MeshType>
PolygonReport triangulatePolygons(MeshType& mesh) {
	if (mesh.fn == 0)
		throw EmptyMesh("The mesh has no faces: open a mesh with polygon faces.");
	const TriangleMesh shape = readTriangles(
		mesh, vcg::tri::HasPerWedgeTexCoord(mesh) ? SeamKind::TextureIslands : SeamKind::ConnectedComponents);
	requireFiniteCoordinates(shape);
	std::vector<char> faux;
	faux.reserve(3 * shape.face.size());
	for (const int face : shape.face)
		for (int side = 0; side < 3; ++side)
			faux.push_back(mesh.face[face].IsF(side));

	const detail::PolygonPlan plan = detail::planPolygons(shape, faux);
	std::vector<detail::FaceCorner<MeshType>> corners;
	for (const detail::NewTriangle& triangle : plan.triangles)
		for (int side = 0; side < 3; ++side)
			corners.emplace_back(mesh, shape, triangle.halfEdge[side], triangle.diagonal[side]);
	auto corner = corners.begin();
	for (const detail::NewTriangle& triangle : plan.triangles)
		for (int side = 0; side < 3; ++side)
			(corner++)->writeTo(mesh, mesh.face[shape.face[triangle.triangle]], side);
	return {plan.polygons, plan.newDiagonals, plan.skipped};
}

} // namespace developable
