// SPDX-License-Identifier: GPL-3.0-or-later
// surface_distance.cpp: asks a tree of the surface's triangles for one point after the other.
#include "surface_distance.h"

#include "spatial_order.h"
#include "triangle_tree.h"

namespace developable {

Eigen::VectorXd distancesToSurface(const Positions& points, const Positions& vertices,
								   const Eigen::Matrix3Xi& triangles) {
	detail::TriangleTree tree(vertices, triangles);
	Eigen::VectorXd distances(points.cols());
	for (const int i : spatialOrder(points))
		distances[i] = tree.distance(points.col(i));
	return distances;
}

} // namespace developable
