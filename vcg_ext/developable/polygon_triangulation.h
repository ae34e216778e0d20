// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_triangulation.h: polygon faces by constrained Delaunay triangulation (Section 3.1).
//
// A polygon is what hosts load a quad or an n-gon as: triangles joined by faux edges, its diagonals. It is
// projected to the least-squares plane of its contour and triangulated there; no vertex is added. The
// triangulation is CGAL's, whose headers this file needs (Debian: libcgal-dev); nothing else of the library
// includes it, so a build may do without.
#pragma once

#include "detail/polygon_planner.h"
#include "mesh_reader.h"

#include <optional>

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

/// The constrained Delaunay triangulation of a polygon in its least-squares plane.
/// \param contour  3 x corners, in order, finite
/// \return         3 x (corners - 2), corners, turning as the contour does; nothing when the contour
///                 crosses or touches itself in the plane
inline std::optional<Eigen::Matrix3Xi> triangulatePolygon(const Positions& contour) {
	const Eigen::Matrix2Xd projected = detail::projectedContour(contour);
	if (contour.cols() < 3 || !detail::isSimplePolygon(projected))
		return std::nullopt;
	return detail::ConstrainedDelaunay(projected).triangles();
}

namespace detail {

/// Bits of a vcg face that belong to its edges: the first of three each.
template <class FaceType>
inline constexpr std::array<int, 2> contourBits = {FaceType::BORDER0, FaceType::FACEEDGESEL0};

/// A corner of a vcg face, and the side that begins there.
template <class MeshType>
struct FaceCorner {
	using Face = typename MeshType::FaceType;

	FaceCorner(MeshType& mesh, const TriangleMesh& shape, int halfEdge, bool diagonal) {
		Face& face = mesh.face[shape.face[halfEdge / 3]];
		const int corner = halfEdge % 3;
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
/// \throws EmptyMesh          when there is no face
/// \throws InvalidCoordinate  when a coordinate is not finite
template <class MeshType>
PolygonReport triangulatePolygons(MeshType& mesh) {
	if (mesh.fn == 0)
		throw EmptyMesh("The mesh has no faces: open a mesh with polygon faces.");
	const TriangleMesh shape = readTriangles(
		mesh, vcg::tri::HasPerWedgeTexCoord(mesh) ? SeamKind::TextureIslands : SeamKind::ConnectedComponents);
	detail::requireFiniteCoordinates(shape);
	std::vector<char> faux;
	faux.reserve(3 * shape.face.size());
	for (const int face : shape.face)
		for (int side = 0; side < 3; ++side)
			faux.push_back(mesh.face[face].IsF(side));

	const detail::PolygonPlanner planner(shape, faux);
	std::vector<detail::FaceCorner<MeshType>> corners;
	for (const detail::NewTriangle& triangle : planner.triangles())
		for (int side = 0; side < 3; ++side)
			corners.emplace_back(mesh, shape, triangle.halfEdge[side], triangle.diagonal[side]);
	for (std::size_t i = 0; i < corners.size(); ++i)
		corners[i].writeTo(mesh, mesh.face[shape.face[planner.triangles()[i / 3].triangle]],
						   static_cast<int>(i % 3));
	return {planner.polygonCount(), planner.newDiagonalCount(), planner.skippedCount()};
}

} // namespace developable
