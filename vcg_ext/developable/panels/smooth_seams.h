// SPDX-License-Identifier: GPL-3.0-or-later
// smooth_seams.h: seams as smooth curves across triangles, which are split along them.
#pragma once

#include "cut_mesh.h"
#include "memberships.h"

namespace developable::detail {

/// A mesh whose vertices are the copies of an assembly, some of its triangles split.
struct SplitMesh {
	TriangleMesh mesh;                 ///< `face` is the triangle that each one is part of
	std::vector<VertexOrigin> origins; ///< per vertex, on the mesh that was split
	std::vector<int> labels;           ///< per triangle
};

/// Splits triangles where memberships are equal. Where that is near a vertex, the curve goes through it.
/// \param mesh  its triangles are those of the surface
SplitMesh splitAlongSeams(const TriangleMesh& mesh, const CutSurface& surface,
						  const Memberships& memberships);

} // namespace developable::detail
