// SPDX-License-Identifier: GPL-3.0-or-later
// joined_faces.h: which faces are joined across which edge; patches and vertex copies follow from it.
#pragma once

#include "../triangle_mesh.h"
#include "disjoint_sets.h"

#include <algorithm>
#include <array>

namespace developable::detail {

/// Half edge h = 3 * triangle + corner runs from that corner to the next one of its triangle.
inline int nextCorner(int corner) {
	return corner % 3 == 2 ? corner - 2 : corner + 1;
}

inline int vertexAt(const TriangleMesh& mesh, int corner) {
	return mesh.triangles(corner % 3, corner / 3);
}

/// Half edges sorted by their ends: first by the smaller vertex, in buckets, then by the larger.
class HalfEdgesByEnds {
public:
	explicit HalfEdgesByEnds(const TriangleMesh& mesh) : mesh_(mesh), start_(mesh.vertexCount() + 1, 0) {
		const int count = 3 * mesh.triangleCount();
		for (int halfEdge = 0; halfEdge < count; ++halfEdge)
			++start_[ends(halfEdge)[0] + 1];
		for (std::size_t vertex = 1; vertex < start_.size(); ++vertex)
			start_[vertex] += start_[vertex - 1];
		halfEdges_.resize(count);
		std::vector<int> next(start_.begin(), start_.end() - 1);
		for (int halfEdge = 0; halfEdge < count; ++halfEdge)
			halfEdges_[next[ends(halfEdge)[0]]++] = halfEdge;
		for (std::size_t vertex = 0; vertex + 1 < start_.size(); ++vertex)
			std::stable_sort(halfEdges_.begin() + start_[vertex], halfEdges_.begin() + start_[vertex + 1],
							 [this](int a, int b) { return ends(a)[1] < ends(b)[1]; });
	}

	/// Calls visit(first, last) with the half edges of each edge.
	template <class Visit>
	void forEachEdge(Visit visit) const {
		for (auto first = halfEdges_.begin(); first != halfEdges_.end();) {
			const auto edge = ends(*first);
			const auto last = std::find_if(first, halfEdges_.end(), [&](int h) { return ends(h) != edge; });
			visit(first, last);
			first = last;
		}
	}

private:
	std::array<int, 2> ends(int halfEdge) const {
		const int a = vertexAt(mesh_, halfEdge), b = vertexAt(mesh_, nextCorner(halfEdge));
		return {std::min(a, b), std::max(a, b)};
	}

	const TriangleMesh& mesh_;
	std::vector<int> start_, halfEdges_;
};

/// The corner of the other half edge's triangle that lies at the same vertex as this corner of this half
/// edge.
inline int cornerAcross(const TriangleMesh& mesh, int corner, int otherHalfEdge) {
	return vertexAt(mesh, corner) == vertexAt(mesh, otherHalfEdge) ? otherHalfEdge
																   : nextCorner(otherHalfEdge);
}

inline bool isSeam(const TriangleMesh& mesh, int halfEdge, int other) {
	if (mesh.cornerLabel.empty())
		return false;
	const int next = nextCorner(halfEdge);
	return mesh.cornerLabel[halfEdge] != mesh.cornerLabel[cornerAcross(mesh, halfEdge, other)] ||
		   mesh.cornerLabel[next] != mesh.cornerLabel[cornerAcross(mesh, next, other)];
}

/// Per half edge the one that its face is joined to across it, or -1: faces are joined across an edge that
/// exactly two faces share, unless it is a seam. Their orientations need not agree.
inline std::vector<int> joinedHalfEdges(const TriangleMesh& mesh) {
	std::vector<int> joined(3 * mesh.triangleCount(), -1);
	HalfEdgesByEnds(mesh).forEachEdge([&](auto first, auto last) {
		if (last - first != 2 || isSeam(mesh, first[0], first[1]))
			return;
		joined[first[0]] = first[1];
		joined[first[1]] = first[0];
	});
	return joined;
}

/// Numbers the fans of joined faces round the vertices, per corner: the vertex copies.
inline Numbering numberCopies(const TriangleMesh& mesh, const std::vector<int>& joined) {
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

/// Numbers the patches, per triangle.
inline Numbering numberPatches(const std::vector<int>& joined) {
	DisjointSets triangles(static_cast<int>(joined.size() / 3));
	for (int halfEdge = 0; halfEdge < static_cast<int>(joined.size()); ++halfEdge)
		if (joined[halfEdge] >= 0)
			triangles.unite(halfEdge / 3, joined[halfEdge] / 3);
	return triangles.numbering();
}

} // namespace developable::detail
