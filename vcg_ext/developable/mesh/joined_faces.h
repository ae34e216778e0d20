// SPDX-License-Identifier: GPL-3.0-or-later
// joined_faces.h: which faces are joined across which edge; patches and vertex copies follow from it.
#pragma once

#include "disjoint_sets.h"
#include "grouping.h"
#include "indices.h"
#include "triangle_mesh.h"

#include <algorithm>
#include <array>

namespace developable {

/// The vertex at a corner, or at the start of a half edge.
inline int vertexAt(const TriangleMesh& mesh, int corner) {
	return mesh.triangles.data()[corner];
}

/// Half edges sorted by their ends: first by the smaller vertex, in buckets, then by the larger.
class HalfEdgesByEnds {
public:
	explicit HalfEdgesByEnds(const TriangleMesh& mesh);

	/// Calls visit(first, last) with the half edges of each edge.
	template <class Visit>
	void forEachEdge(Visit visit) const {
		const std::vector<int>& halfEdges = byStart_.members;
		for (auto first = halfEdges.begin(); first != halfEdges.end();) {
			const auto edge = ends(*first);
			const auto last = std::find_if(first, halfEdges.end(), [&](int h) { return ends(h) != edge; });
			visit(first, last);
			first = last;
		}
	}

private:
	std::array<int, 2> ends(int halfEdge) const;

	const TriangleMesh& mesh_;
	Groups byStart_; // by the smaller of their ends
};

/// The corner of the other half edge's triangle that lies at the same vertex as this corner of this half
/// edge.
int cornerAcross(const TriangleMesh& mesh, int corner, int otherHalfEdge);

/// Whether the labels at an edge, given by its two half edges, say that it parts two patches.
bool isSeam(const TriangleMesh& mesh, int halfEdge, int other);

/// Per half edge the one that its face is joined to across it, or -1: faces are joined across an edge that
/// exactly two faces share, unless it is a seam. Their orientations need not agree.
std::vector<int> joinedHalfEdges(const TriangleMesh& mesh);

/// Numbers the fans of joined faces round the vertices, per corner: the vertex copies.
Numbering numberCopies(const TriangleMesh& mesh, const std::vector<int>& joined);

/// Numbers the patches, per triangle.
Numbering numberPatches(const std::vector<int>& joined);

} // namespace developable
