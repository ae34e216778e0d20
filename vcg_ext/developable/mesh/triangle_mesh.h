// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_mesh.h: a triangle mesh as flat arrays in double precision, whatever host it came from.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace developable {

/// Coordinates of vertices or of object vertices, one column each, in the mesh's unit of length.
using Positions = Eigen::Matrix3Xd;

/// The diagonal of the box round some points, one column each; length.
template <class Points>
double boxDiagonal(const Eigen::MatrixBase<Points>& points) {
	return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// What of a mesh decides how it falls into patches, and what of them may move.
struct TriangleMesh {
	Positions positions;                ///< 3 x vertices, deleted ones included
	std::vector<char> vertexSelected;   ///< per vertex
	Eigen::Matrix3Xi triangles;         ///< 3 x triangles, vertices
	std::vector<char> triangleSelected; ///< per triangle
	std::vector<int> face;              ///< per triangle, its index among the mesh's faces

	/// Per corner (3 * triangle + corner), or empty: two faces that share an edge belong together only if
	/// their labels are equal at both of its ends.
	std::vector<int> cornerLabel;

	/// A triangle lower than this share of its longest edge has no area, as far as the mesh's numbers can
	/// tell.
	double leastHeightRatio = 1e-12;

	/// Whether all coordinates are numbers of single precision: so are those of points that are put in, and
	/// any host reads them to the last bit.
	bool singlePrecision = false;

	/// Positions times 2 to this power are those of the mesh that was read; see length_unit.h.
	int lengthExponent = 0;

	int vertexCount() const { return static_cast<int>(positions.cols()); }
	int triangleCount() const { return static_cast<int>(triangles.cols()); }
};

} // namespace developable
