// SPDX-License-Identifier: GPL-3.0-or-later
// surface_distance.cpp: asks a tree of the surface's triangles for one point after the other.
#include "surface_distance.h"

#include "spatial_order.h"
#include "triangle_tree.h"

namespace developable {

Positions nearestOnSurface(const Positions& points, const Positions& vertices,
						   const Eigen::Matrix3Xi& triangles) {
	detail::TriangleTree tree(vertices, triangles);
	Positions nearest(3, points.cols());
	for (const int i : spatialOrder(points))
		nearest.col(i) = tree.nearestTo(points.col(i));
	return nearest;
}

Eigen::VectorXd distancesToSurface(const Positions& points, const Positions& vertices,
								   const Eigen::Matrix3Xi& triangles) {
	return (points - nearestOnSurface(points, vertices, triangles)).colwise().norm();
}

std::vector<int> nearestTriangles(const Positions& points, const Positions& vertices,
								  const Eigen::Matrix3Xi& triangles) {
	detail::TriangleTree tree(vertices, triangles);
	std::vector<int> nearest(points.cols());
	for (const int i : spatialOrder(points))
		nearest[i] = tree.nearestTriangleTo(points.col(i));
	return nearest;
}

} // namespace developable
