// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_tree.h: the triangle of a surface that is nearest to a point, by a tree of boxes.
#pragma once

#include "developable/mesh/mesh.h"

#include <unsupported/Eigen/BVH>

namespace developable::detail {

/// Eigen's tree of boxes over triangles. Its own search begins without a bound; this one begins with the
/// triangle that was nearest before, which halves its time where points follow each other.
class TriangleTree {
public:
	/// Both must outlive the tree; at least one triangle.
	TriangleTree(const Positions& vertices, const Eigen::Matrix3Xi& triangles);

	/// The point of the surface that is nearest to one.
	Eigen::Vector3d nearestTo(const Eigen::Vector3d& point);
	/// The triangle that has it.
	int nearestTriangleTo(const Eigen::Vector3d& point);

private:
	Eigen::Vector3d nearestIn(int triangle, const Eigen::Vector3d& point) const;

	/// Looks at a node's triangles, then at its boxes, the nearer one first.
	void descend(int node, const Eigen::Vector3d& point);

	/// Descends where something nearer may be.
	void visit(int node, double squaredDistanceToBox, const Eigen::Vector3d& point);

	const Positions& vertices_;
	const Eigen::Matrix3Xi& triangles_;
	Eigen::KdBVH<double, 3, int> tree_;
	int nearest_ = 0; ///< to the point that was asked for last
	double squaredDistance_ = 0;
};

} // namespace developable::detail
