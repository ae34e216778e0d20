// SPDX-License-Identifier: GPL-3.0-or-later
// linked_vertices.h: linked vertex sets of mesh vertices that coincide (Section 4.2).
#pragma once

#include "disjoint_sets.h"
#include "triangle_mesh.h"

namespace developable::detail {

/// Numbers the places of the vertices that the triangles use; -1 for the other vertices. Vertices at most
/// weldDistance apart share a place, transitively; with 0 those with equal coordinates do.
/// \throws DegenerateTriangle  when two corners of a triangle would share a place
Numbering numberPlaces(const TriangleMesh& mesh, double weldDistance);

} // namespace developable::detail
