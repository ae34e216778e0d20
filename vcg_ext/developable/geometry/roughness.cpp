// SPDX-License-Identifier: GPL-3.0-or-later
// roughness.cpp: sums up the folds between neighbouring faces.
#include "roughness.h"

#include "vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace developable {

namespace {

/// \param visit  called for each edge that faces share within their patch, with its index and the angle
///               between their normals
template <class Visit>
void forEachFold(const PatchAssembly& assembly, const Positions& positions, const Visit& visit) {
	const Eigen::Matrix3Xd normals = areaNormals(assembly, positions);
	for (int edge = 0; edge < assembly.edgeCount(); ++edge) {
		const int halfEdge = assembly.edgeHalfEdge[edge], across = assembly.across(halfEdge);
		if (across < 0)
			continue;
		const Eigen::Vector3d normal = normals.col(triangleOf(halfEdge)),
							  neighbour = normals.col(triangleOf(across));
		visit(edge, std::atan2(normal.cross(neighbour).norm(), normal.dot(neighbour)));
	}
}

} // namespace

double roughness(const PatchAssembly& assembly, const Positions& positions) {
	double sum = 0;
	int count = 0;
	forEachFold(assembly, positions, [&](int, double angle) {
		sum += angle * angle;
		++count;
	});
	return count > 0 ? std::sqrt(sum / count) : 0;
}

double meanAbsoluteCurvature(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::VectorXd lengths = edgeLengths(assembly, positions);
	double sum = 0;
	forEachFold(assembly, positions, [&](int edge, double angle) { sum += lengths[edge] * angle / 2; });
	return sum;
}

} // namespace developable
