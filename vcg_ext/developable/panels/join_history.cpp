// SPDX-License-Identifier: GPL-3.0-or-later
// join_history.cpp: halves of panels, by their triangles.
#include "join_history.h"

#include <algorithm>

namespace developable::detail {

void JoinHistory::join(CutSurface& surface, const std::vector<int>& halfEdges) {
	const int first = surface.panelOf(triangleOf(halfEdges.front()));
	const int second = surface.panelOf(triangleOf(surface.assembly().across(halfEdges.front())));
	std::vector<int> half = surface.trianglesOf(first);
	const int panel = surface.join(halfEdges);
	if (first != second)
		halves_[surface.trianglesOf(panel)] = std::move(half);
}

bool JoinHistory::takeBack(CutSurface& surface, int panel) {
	const std::vector<int> whole = surface.trianglesOf(panel);
	const auto found = halves_.find(whole);
	if (found == halves_.end())
		return false;
	std::vector<int> labels;
	labels.reserve(whole.size());
	for (const int triangle : whole)
		labels.push_back(std::binary_search(found->second.begin(), found->second.end(), triangle));
	surface.divide(panel, labels);
	takenBack_.insert(whole);
	return true;
}

} // namespace developable::detail
