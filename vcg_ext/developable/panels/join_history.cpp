// SPDX-License-Identifier: GPL-3.0-or-later
// join_history.cpp: halves of panels, and pairs that stay apart.
#include "join_history.h"

#include <algorithm>

namespace developable::detail {

int JoinHistory::numberOf(const CutSurface& surface, int panel) {
	return numbers_.emplace(surface.trianglesOf(panel), static_cast<int>(numbers_.size())).first->second;
}

JoinHistory::Pair JoinHistory::pairAt(const CutSurface& surface, int halfEdge) {
	const int a = numberOf(surface, surface.panelOf(triangleOf(halfEdge)));
	const int b = numberOf(surface, surface.panelOf(triangleOf(surface.assembly().across(halfEdge))));
	return {std::min(a, b), std::max(a, b)};
}

void JoinHistory::join(CutSurface& surface, const std::vector<int>& halfEdges) {
	const int first = surface.panelOf(triangleOf(halfEdges.front()));
	const int second = surface.panelOf(triangleOf(surface.assembly().across(halfEdges.front())));
	std::vector<int> half = surface.trianglesOf(first);
	const int whole = surface.join(halfEdges);
	if (first != second)
		halves_[numberOf(surface, whole)] = std::move(half);
}

bool JoinHistory::takeBack(CutSurface& surface, int panel) {
	const std::vector<int> whole = surface.trianglesOf(panel);
	const auto found = halves_.find(numberOf(surface, panel));
	if (found == halves_.end())
		return false;
	const std::vector<int>& half = found->second;
	std::vector<int> labels;
	labels.reserve(whole.size());
	for (const int triangle : whole)
		labels.push_back(std::binary_search(half.begin(), half.end(), triangle));
	surface.divide(panel, labels);
	takenBack_.insert(whole);
	return true;
}

void JoinHistory::refuse(const CutSurface& surface, const std::vector<int>& halfEdges) {
	refused_.emplace(pairAt(surface, halfEdges.front()),
					 *std::min_element(halfEdges.begin(), halfEdges.end()));
}

bool JoinHistory::wasRefused(const CutSurface& surface, const std::vector<int>& halfEdges) {
	const Pair pair = pairAt(surface, halfEdges.front());
	return refused_.count({pair, *std::min_element(halfEdges.begin(), halfEdges.end())}) > 0 ||
		   (!takenBack_.empty() && takenBack_.count(surface.trianglesAtBothSides(halfEdges.front())) > 0);
}

} // namespace developable::detail
