// SPDX-License-Identifier: GPL-3.0-or-later
// seams.cpp: follows pairs of boundary half edges along both of their boundaries.
#include "seams.h"

#include <algorithm>
#include <array>
#include <deque>

namespace developable {

namespace {

/// Pairs boundary half edges of patterns whose ends are linked, and follows the pairs along the boundaries.
class SeamFinder {
public:
	SeamFinder(const PatchAssembly& assembly, const FlatPatterns& patterns)
		: assembly_(assembly), patterns_(patterns), partner_(patterns.joinedHalfEdge.size(), -1),
		  boundary_(patterns.vertexCount(), {-1, -1}), seen_(patterns.joinedHalfEdge.size(), 0) {
		for (int h = 0; h < static_cast<int>(partner_.size()); ++h)
			if (patterns.joinedHalfEdge[h] < 0)
				for (const int vertex : {patterns.vertexAt(h), patterns.vertexAt(nextCorner(h))})
					boundary_[vertex][boundary_[vertex][0] >= 0] = h;
		walkBoundaries();
		std::vector<std::array<int, 3>> sorted; // two places and the number in order_ of what joins them
		for (int number = 0; number < static_cast<int>(order_.size()); ++number) {
			const int start = place(order_[number]), end = place(nextCorner(order_[number]));
			sorted.push_back({std::min(start, end), std::max(start, end), number});
		}
		std::sort(sorted.begin(), sorted.end());
		std::size_t first = 0;
		for (std::size_t i = 1; i < sorted.size(); ++i) {
			if (sorted[i][0] != sorted[first][0] || sorted[i][1] != sorted[first][1]) {
				first = i;
				continue;
			}
			// Where three or more meet, each is sewn to the first.
			const int one = order_[sorted[first][2]], other = order_[sorted[i][2]];
			partner_[other] = one;
			if (partner_[one] < 0)
				partner_[one] = other;
		}
	}

	std::vector<Seam> find() {
		std::vector<Seam> seams;
		for (const int h : order_)
			if (partner_[h] >= 0 && !seen_[h])
				seams.push_back(seamThrough(h));
		return seams;
	}

private:
	/// Puts the half edges of the boundaries in order, one boundary after the other, each from its first
	/// vertex towards the lesser of the two beside it. So the order of the triangles does not matter, and
	/// where three or more half edges meet, the first of them is so on the same boundary all along the seam.
	void walkBoundaries() {
		std::vector<char> passed(partner_.size(), 0);
		for (int first = 0; first < patterns_.vertexCount(); ++first) {
			int h = boundary_[first][0];
			if (h >= 0 && otherEnd(first, boundary_[first][1]) < otherEnd(first, h))
				h = boundary_[first][1];
			for (int vertex = first; h >= 0 && !passed[h]; h = otherAt(vertex, h)) {
				passed[h] = 1;
				order_.push_back(h);
				vertex = otherEnd(vertex, h);
			}
		}
	}

	/// The vertex of a half edge that is not this one.
	int otherEnd(int vertex, int halfEdge) const {
		const int start = patterns_.vertexAt(halfEdge);
		return start == vertex ? patterns_.vertexAt(nextCorner(halfEdge)) : start;
	}

	/// The other half edge of the boundary at a vertex.
	int otherAt(int vertex, int halfEdge) const {
		return boundary_[vertex][boundary_[vertex][0] == halfEdge];
	}

	int place(int corner) const { return assembly_.placeAt(corner); }

	void mark(int h) {
		seen_[h] = 1;
		if (partner_[partner_[h]] == h)
			seen_[partner_[h]] = 1;
	}

	/// The end of a half edge that lies at a place.
	int vertexAtPlace(int halfEdge, int atPlace) const {
		return patterns_.vertexAt(place(halfEdge) == atPlace ? halfEdge : nextCorner(halfEdge));
	}

	/// The half edge that goes on with the seam beyond the end of one at a corner, or -1.
	int beyond(int halfEdge, int corner) const {
		const int next = otherAt(patterns_.vertexAt(corner), halfEdge);
		if (seen_[next] || partner_[next] < 0)
			return -1;
		const int across = partner_[halfEdge];
		return otherAt(vertexAtPlace(across, place(corner)), across) == partner_[next] ? next : -1;
	}

	/// The seam that a half edge is in; it runs towards the lesser place there.
	Seam seamThrough(int first) {
		std::deque<int> chain = {first};
		mark(first);
		const bool turned = place(first) < place(nextCorner(first));
		for (const bool forward : {true, false})
			for (int h = first, corner = forward != turned ? nextCorner(first) : first;;) {
				const int atPlace = place(corner);
				h = beyond(h, corner);
				if (h < 0)
					break;
				mark(h);
				if (forward)
					chain.push_back(h);
				else
					chain.push_front(h);
				corner = place(h) == atPlace ? nextCorner(h) : h;
			}
		Seam seam;
		seam.piece = {piece(first), piece(partner_[first])};
		for (const int h : chain) {
			seam.halfEdges[0].push_back(h);
			seam.halfEdges[1].push_back(partner_[h]);
			seam.length[0] += patterns_.length(h);
			seam.length[1] += patterns_.length(partner_[h]);
		}
		return seam;
	}

	int piece(int halfEdge) const { return patterns_.pieceOfVertex[patterns_.vertexAt(halfEdge)]; }

	const PatchAssembly& assembly_;
	const FlatPatterns& patterns_;
	std::vector<int> partner_;                 // per half edge the one that it is sewn to, or -1
	std::vector<std::array<int, 2>> boundary_; // per vertex the half edges of the boundary that end there
	std::vector<int> order_;                   // the half edges of the boundaries
	std::vector<char> seen_;
};

} // namespace

std::vector<Seam> findSeams(const PatchAssembly& assembly, const FlatPatterns& patterns) {
	return SeamFinder(assembly, patterns).find();
}

} // namespace developable
