// SPDX-License-Identifier: GPL-3.0-or-later
// roughness.h: how wrinkled a shape is, which D and G do not say (Section 6 on Fig. 10).
#pragma once

#include "patch_assembly.h"

#include <cmath>

namespace developable {

/// Root mean square of the angle between the normals of faces that share an edge of their patch, rad. Faces
/// of a patch count as oriented like its first one; seams between patches don't count. 0 where no faces are
/// neighbours.
inline double roughness(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd normals(3, assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		const Eigen::Vector3d a = positions.col(places[1]) - positions.col(places[0]);
		const Eigen::Vector3d b = positions.col(places[2]) - positions.col(places[0]);
		normals.col(t) = (assembly.triangleReversed[t] ? -1 : 1) * a.cross(b);
	}
	double sum = 0;
	int count = 0;
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.joinedHalfEdge[halfEdge];
		if (across < 0)
			continue;
		const Eigen::Vector3d normal = normals.col(halfEdge / 3), neighbour = normals.col(across / 3);
		const double angle = std::atan2(normal.cross(neighbour).norm(), normal.dot(neighbour));
		sum += angle * angle;
		++count;
	}
	return count > 0 ? std::sqrt(sum / count) : 0;
}

} // namespace developable
