// SPDX-License-Identifier: GPL-3.0-or-later
// border_parts.cpp: round a piece, half edge by half edge.
#include "border_parts.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// Half edges round a piece, in order; none where its border touches itself at a vertex, which has two ways
/// on.
std::vector<int> borderFrom(const FlatPatterns& patterns, int first) {
	std::vector<int> leaving(patterns.vertexCount(), -1);
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h)
		if (patterns.joinedHalfEdge[h] < 0)
			leaving[patterns.vertexAt(h)] = h;
	std::vector<int> border;
	for (int h = first; border.size() < patterns.joinedHalfEdge.size();) {
		border.push_back(h);
		h = leaving[patterns.vertexAt(nextCorner(h))];
		if (h == first)
			return border;
	}
	return {};
}

double lengthOf(const FlatPatterns& patterns, const std::vector<int>& halfEdges) {
	double length = 0;
	for (const int h : halfEdges)
		length += patterns.length(h);
	return length;
}

} // namespace

BorderPart shorterBorderPart(const FlatPatterns& patterns, const std::array<int, 2>& ends) {
	std::vector<int> border = borderFrom(patterns, ends[0]);
	const double whole = lengthOf(patterns, border);
	const auto last = std::find(border.begin(), border.end(), ends[1]);
	if (last == border.end())
		return {};
	BorderPart part{std::vector<int>(border.begin(), last + 1), 0};
	BorderPart other{std::vector<int>(last, border.end()), 0};
	other.halfEdges.push_back(ends[0]);
	for (BorderPart* one : {&part, &other})
		one->share = lengthOf(patterns, one->halfEdges) / whole;
	return part.share <= other.share ? part : other;
}

} // namespace developable::detail
