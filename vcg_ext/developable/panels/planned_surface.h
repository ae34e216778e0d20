// SPDX-License-Identifier: GPL-3.0-or-later
// planned_surface.h: the panels so far and the mesh that they are on, from the patches that were given to the
// mesh that is returned.
#pragma once

#include "cut_mesh.h"
#include "cut_surface.h"

namespace developable::detail {

/// What was given, its patches apart: every copy of a vertex is a vertex of its own.
struct GivenPatches {
	TriangleMesh mesh;
	std::vector<VertexOrigin> origins; ///< per vertex, on the mesh that was given
	std::vector<char> vertexTaken;     ///< per vertex of that mesh: faces that are not worked on have it
	double seamLength = 0;             ///< between patches that share vertices
};

/// Its vertices and triangles are their own origins, and no others have any.
void numberByThemselves(GivenPatches& patches);

/// Of the sides of different patches that have both ends in common on the mesh that was given, length.
double lengthOfSharedSides(const GivenPatches& given);

GivenPatches separatePatches(const TriangleMesh& mesh, const PatchOptions& patches);

/// Panels, and the mesh whose triangles they have: these are split where smooth seams cross them.
struct PlannedSurface {
	TriangleMesh mesh;                 ///< vertices are those of the patches, and points on their edges
	std::vector<VertexOrigin> origins; ///< per vertex, on the mesh that was given
	CutSurface surface;
};

/// A surface's panels, seams and darts on a mesh with the same triangles in another order.
/// \param halfEdge  per half edge of the mesh, that of the surface
PlannedSurface withPanelsOf(const CutSurface& surface, TriangleMesh mesh, std::vector<VertexOrigin> origins,
							const std::vector<int>& halfEdge);

/// \param vertexTaken  as of the patches that were given
CutMesh cutMesh(const PlannedSurface& planned, const std::vector<char>& vertexTaken);

/// The same with its triangles in the order that they have once the mesh is cut; `face` is their number on
/// the surface.
TriangleMesh meshAsCut(const PlannedSurface& planned, const std::vector<char>& vertexTaken);

} // namespace developable::detail
