// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_planner.h: which triangles of a mesh's polygons change, and how; nothing is written.
#pragma once

#include "developable/mesh/mesh.h"

#include <array>

namespace developable::detail {

/// A triangle of a polygon as it will be. It takes the face of `triangle`. Its corners, and the sides that
/// begin there, carry on what the contour's half edges have; a side that is a diagonal becomes a faux edge.
struct NewTriangle {
	int triangle;
	std::array<int, 3> halfEdge;
	std::array<bool, 3> diagonal;
};

/// What is to become of the polygons of a mesh.
struct PolygonPlan {
	int polygons = 0;                   ///< skipped ones included
	int skipped = 0;                    ///< see PolygonReport
	int newDiagonals = 0;               ///< that were not there before
	std::vector<NewTriangle> triangles; ///< those that change
};

/// Plans the triangulation of all polygons of a mesh.
/// \param faux  per half edge, true for the diagonals inside polygons
PolygonPlan planPolygons(const TriangleMesh& mesh, const std::vector<char>& faux);

} // namespace developable::detail
