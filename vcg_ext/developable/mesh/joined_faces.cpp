// SPDX-License-Identifier: GPL-3.0-or-later
// joined_faces.cpp: joins faces across edges; numbers the fans and the patches.
#include "joined_faces.h"

namespace developable {

HalfEdgesByEnds::HalfEdgesByEnds(const TriangleMesh& mesh)
	: mesh_(mesh),
	  byStart_(grouped(mesh.vertexCount(), 3 * mesh.triangleCount(), [this](int h) { return ends(h)[0]; })) {
	for (int vertex = 0; vertex < byStart_.count(); ++vertex)
		std::stable_sort(byStart_.members.begin() + byStart_.start[vertex],
						 byStart_.members.begin() + byStart_.start[vertex + 1],
						 [this](int a, int b) { return ends(a)[1] < ends(b)[1]; });
}

std::array<int, 2> HalfEdgesByEnds::ends(int halfEdge) const {
	const int a = vertexAt(mesh_, halfEdge), b = vertexAt(mesh_, nextCorner(halfEdge));
	return {std::min(a, b), std::max(a, b)};
}

int cornerAcross(const TriangleMesh& mesh, int corner, int otherHalfEdge) {
	return vertexAt(mesh, corner) == vertexAt(mesh, otherHalfEdge) ? otherHalfEdge
																   : nextCorner(otherHalfEdge);
}

bool isSeam(const TriangleMesh& mesh, int halfEdge, int other) {
	if (mesh.cornerLabel.empty())
		return false;
	const int next = nextCorner(halfEdge);
	return mesh.cornerLabel[halfEdge] != mesh.cornerLabel[cornerAcross(mesh, halfEdge, other)] ||
		   mesh.cornerLabel[next] != mesh.cornerLabel[cornerAcross(mesh, next, other)];
}

std::vector<int> joinedHalfEdges(const TriangleMesh& mesh) {
	std::vector<int> joined(3 * mesh.triangleCount(), -1);
	HalfEdgesByEnds(mesh).forEachEdge([&](auto first, auto last) {
		if (last - first != 2 || isSeam(mesh, first[0], first[1]))
			return;
		joined[first[0]] = first[1];
		joined[first[1]] = first[0];
	});
	return joined;
}

Numbering numberCopies(const TriangleMesh& mesh, const std::vector<int>& joined) {
	DisjointSets corners(static_cast<int>(joined.size()));
	for (int halfEdge = 0; halfEdge < static_cast<int>(joined.size()); ++halfEdge) {
		if (joined[halfEdge] < 0)
			continue;
		const int next = nextCorner(halfEdge);
		corners.unite(halfEdge, cornerAcross(mesh, halfEdge, joined[halfEdge]));
		corners.unite(next, cornerAcross(mesh, next, joined[halfEdge]));
	}
	return corners.numbering();
}

Numbering numberPatches(const std::vector<int>& joined) {
	DisjointSets triangles(triangleOf(static_cast<int>(joined.size())));
	for (int halfEdge = 0; halfEdge < static_cast<int>(joined.size()); ++halfEdge)
		if (joined[halfEdge] >= 0)
			triangles.unite(triangleOf(halfEdge), triangleOf(joined[halfEdge]));
	return triangles.numbering();
}

} // namespace developable
