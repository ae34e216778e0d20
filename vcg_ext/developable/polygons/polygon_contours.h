// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_contours.h: the polygons of a triangle mesh whose faux edges join triangles to polygons.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable::detail {

/// A polygon made of triangles.
struct Polygon {
	std::vector<int> triangles;
	/// The half edges round it, each beginning where the last one ended; empty when its triangles do not form
	/// a disk of consistent orientation with all vertices on its rim, or a texture seam runs through it.
	std::vector<int> contour;
};

/// All polygons of more than one triangle, and triangles with a faux edge that nothing matches.
/// \param faux  per half edge, true for the diagonals inside polygons
std::vector<Polygon> findPolygons(const TriangleMesh& mesh, const std::vector<char>& faux);

} // namespace developable::detail
