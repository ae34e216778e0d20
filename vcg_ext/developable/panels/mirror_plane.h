// SPDX-License-Identifier: GPL-3.0-or-later
// mirror_plane.h: the plane about which a surface is its own mirror image, if it is one.
#pragma once

#include "developable/mesh/mesh.h"

#include <vector>

namespace developable::detail {

struct MirrorPlane {
	Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< unit length
	double offset = 0;                                 ///< of the plane along the normal
	/// From vertices of the mirror image to the surface, as shares of the diagonal of its box.
	double meanDistance = 1, greatestDistance = 1;

	/// Whether people would call the surface symmetric.
	bool isSymmetric() const { return meanDistance <= 0.003 && greatestDistance <= 0.02; }

	double heightOf(const Eigen::Vector3d& point) const { return normal.dot(point) - offset; }
	Eigen::Vector3d mirrored(const Eigen::Vector3d& point) const {
		return point - 2 * heightOf(point) * normal;
	}
};

/// The best plane found: from planes through the centre of area, along the principal axes and directions in
/// between, by closest points (ICP: Besl and McKay 1992) of the mirror image on the surface.
MirrorPlane mirrorPlane(const TriangleMesh& mesh);

/// Of each triangle the one whose middle is nearest to the mirror image of its own.
std::vector<int> mirroredTriangles(const TriangleMesh& mesh, const MirrorPlane& plane);

} // namespace developable::detail
