// SPDX-License-Identifier: GPL-3.0-or-later
// cut_mesh.h: a mesh that was cut: its triangles, some of them split, and vertices doubled along seams.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace developable {

/// Where a vertex lies on the mesh before: at (1 − share) · first + share · second, which are vertices of the
/// mesh before and equal for one of those.
struct VertexOrigin {
	int first = -1, second = -1;
	double share = 0;
};

/// \param positions  of the vertices of the mesh before, 3 x vertices
inline Eigen::Vector3d pointAt(const VertexOrigin& origin, const Eigen::Matrix3Xd& positions) {
	if (origin.first == origin.second)
		return positions.col(origin.first);
	return (1 - origin.share) * positions.col(origin.first) + origin.share * positions.col(origin.second);
}

/// The triangles that were worked on after the cut, and the vertices that they have.
struct CutMesh {
	int verticesBefore = 0;
	std::vector<VertexOrigin> added; ///< the vertices behind those of the mesh before
	Eigen::Matrix3Xi triangles;      ///< 3 x triangles, vertices before or added
	std::vector<int> face;           ///< per triangle, the face of the mesh before that it is or is a part of
	std::vector<int> panel;          ///< per triangle, from 0
	/// Per triangle and side (3 · triangle + corner): 1 where a seam or a dart runs.
	std::vector<char> seam;

	/// Per triangle its place among the faces once the mesh is cut: the first part of a face keeps the
	/// face's, others follow behind all that there were.
	std::vector<int> facesAfter(int facesBefore) const {
		std::vector<char> taken(facesBefore, 0);
		std::vector<int> after;
		int next = facesBefore;
		for (const int f : face) {
			after.push_back(taken[f] ? next++ : f);
			taken[f] = 1;
		}
		return after;
	}

	VertexOrigin originOf(int vertex) const {
		return vertex < verticesBefore ? VertexOrigin{vertex, vertex, 0} : added[vertex - verticesBefore];
	}
};

} // namespace developable
