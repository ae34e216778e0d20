// SPDX-License-Identifier: GPL-3.0-or-later
// panel_mesh.h: one patch by itself, oriented, as flattening works on it; its boundary loops, and cutting it.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

namespace developable::detail {

using PlanePositions = Eigen::Matrix2Xd;

/// One patch, its half edges numbered as everywhere.
struct PanelMesh {
	Positions positions;             ///< 3 x vertices, on the model, relative to the panel's middle
	Eigen::Matrix3Xi triangles;      ///< 3 x triangles, counterclockwise seen from outside
	std::vector<int> joinedHalfEdge; ///< per half edge the one across it, or -1
	std::vector<int> vertexBefore;   ///< per vertex, the one that it was before the panel was cut

	int vertexCount() const { return static_cast<int>(positions.cols()); }
	int triangleCount() const { return static_cast<int>(triangles.cols()); }
	int halfEdgeCount() const { return static_cast<int>(triangles.size()); }
	int start(int halfEdge) const { return triangles.data()[halfEdge]; }
	int end(int halfEdge) const { return start(nextCorner(halfEdge)); }
	double length(int halfEdge) const {
		return (positions.col(end(halfEdge)) - positions.col(start(halfEdge))).norm();
	}
	/// True for one half edge of every edge.
	bool firstOfEdge(int halfEdge) const {
		return joinedHalfEdge[halfEdge] < 0 || halfEdge < joinedHalfEdge[halfEdge];
	}
	TriangleFrame frame(int triangle) const {
		return {positions.col(triangles(0, triangle)), positions.col(triangles(1, triangle)),
				positions.col(triangles(2, triangle))};
	}
};

/// Twice the signed area of a triangle in the plane.
inline double doubleArea(const PlanePositions& positions, const Eigen::Ref<const Eigen::Vector3i>& triangle) {
	const Eigen::Vector2d a = positions.col(triangle[1]) - positions.col(triangle[0]);
	const Eigen::Vector2d b = positions.col(triangle[2]) - positions.col(triangle[0]);
	return a[0] * b[1] - a[1] * b[0];
}

/// How many triangles of a layout turn clockwise or have no area.
int countFlipped(const Eigen::Matrix3Xi& triangles, const PlanePositions& positions);

/// The boundary loops as half edges, each in the direction of its triangles: the outer one of a flat panel
/// runs counterclockwise.
std::vector<std::vector<int>> boundaryLoops(const PanelMesh& panel);

/// The sum of the corner angles at every vertex, rad.
Eigen::VectorXd angleSums(const PanelMesh& panel);

/// The panel cut open along edges, each given by one of its half edges.
PanelMesh cutOpen(const PanelMesh& panel, const std::vector<int>& halfEdges);

} // namespace developable::detail
