// SPDX-License-Identifier: GPL-3.0-or-later
// surface_distance.h: how far points are from a triangle surface (the distance error map of Fig. 8 and 9).
#pragma once

#include "detail/closest_triangle.h"

#include <vcg/space/triangle3.h>

#include <vcg/space/index/aabb_binary_tree/aabb_binary_tree.h>

#include <vector>

namespace developable {

/// Distance from each point to the nearest point of a surface. Quickest when points that follow each other are near
/// each other.
///
/// The index is vcglib's box tree: its uniform grid is as quick for points on the surface, but needs a hundred times
/// as long for points at some distance, as it looks at every cell of a growing cube.
///
/// \param points     3 x any number, anywhere, in the surface's unit of length
/// \param vertices   3 x vertices of the surface
/// \param triangles  3 x triangles, at least one; all coordinates finite
/// \return           per point, in the same unit, 0 or more
inline Eigen::VectorXd distancesToSurface(const Positions& points, const Positions& vertices,
										  const Eigen::Matrix3Xi& triangles) {
	std::vector<detail::IndexedTriangle> indexed;
	indexed.reserve(triangles.cols());
	for (const auto& corners : triangles.colwise())
		indexed.emplace_back(vertices.col(corners[0]), vertices.col(corners[1]), vertices.col(corners[2]));
	vcg::AABBBinaryTreeIndex<detail::IndexedTriangle, double, vcg::EmptyClass> tree;
	tree.Set(indexed.begin(), indexed.end());

	detail::DistanceToTriangle distanceToTriangle;
	int marker = 0; // the tree ignores it
	const detail::IndexedTriangle* last = &indexed.front();
	Eigen::VectorXd distances(points.cols());
	for (Eigen::Index i = 0; i < points.cols(); ++i) {
		// The triangle that was nearest to the point before says how far the search need go.
		const double bound = last->distance(points.col(i));
		const vcg::Point3d point(points(0, i), points(1, i), points(2, i));
		vcg::Point3d nearest;
		distances[i] = bound;
		if (const auto* found = tree.GetClosest(distanceToTriangle, marker, point, bound, distances[i], nearest))
			last = found;
	}
	return distances;
}

} // namespace developable
