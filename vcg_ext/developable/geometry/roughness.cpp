// SPDX-License-Identifier: GPL-3.0-or-later
// roughness.cpp: sums up the folds between neighbouring faces.
#include "roughness.h"

#include "vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace developable {

double roughness(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd normals = areaNormals(assembly, positions);
	double sum = 0;
	int count = 0;
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.across(halfEdge);
		if (across < 0)
			continue;
		const Eigen::Vector3d normal = normals.col(triangleOf(halfEdge)),
							  neighbour = normals.col(triangleOf(across));
		const double angle = std::atan2(normal.cross(neighbour).norm(), normal.dot(neighbour));
		sum += angle * angle;
		++count;
	}
	return count > 0 ? std::sqrt(sum / count) : 0;
}

} // namespace developable
