// SPDX-License-Identifier: GPL-3.0-or-later
// panel_graph.cpp: Dijkstra's algorithm on the edges of a panel.
#include "panel_graph.h"

#include <algorithm>
#include <queue>

namespace developable::detail {

PanelGraph::PanelGraph(const CutSurface& surface, int panel, const std::vector<char>& held)
	: surface_(surface) {
	const int copies = surface.assembly().copyCount();
	inside_.assign(copies, 0);
	onBorder_.assign(copies, 0);
	halfEdges_.resize(copies);
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h) {
			const int across = surface.across(h);
			inside_[surface.startOf(h)] = 1;
			if (across < 0) {
				border_.push_back(surface.startOf(h));
				border_.push_back(surface.endOf(h));
			} else if (across < h && (held.empty() || !held[t] || !held[triangleOf(across)])) {
				halfEdges_[surface.startOf(h)].push_back(h);
				halfEdges_[surface.endOf(h)].push_back(h);
			}
		}
	for (const int copy : border_)
		onBorder_[copy] = 1;
}

PanelGraph::Paths PanelGraph::from(const std::vector<int>& copies) const {
	Paths paths{std::vector<double>(inside_.size(), std::numeric_limits<double>::infinity()),
				std::vector<int>(inside_.size(), -1)};
	using Step = std::pair<double, int>;
	std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
	for (const int copy : copies) {
		paths.length[copy] = 0;
		front.emplace(0, copy);
	}
	while (!front.empty()) {
		const auto [length, copy] = front.top();
		front.pop();
		if (length > paths.length[copy] || (onBorder(copy) && length > 0))
			continue;
		for (const int h : halfEdges_[copy]) {
			const int next = otherEnd(h, copy);
			const double further = length + surface_.length(h);
			const bool alongBorder = onBorder(next) && onBorder(copy);
			if (!alongBorder && further < paths.length[next]) {
				paths.length[next] = further;
				paths.halfEdge[next] = h;
				front.emplace(further, next);
			}
		}
	}
	return paths;
}

std::vector<int> PanelGraph::wayTo(int copy, const Paths& paths) const {
	std::vector<int> way;
	for (; paths.halfEdge[copy] >= 0; copy = otherEnd(paths.halfEdge[copy], copy))
		way.push_back(paths.halfEdge[copy]);
	return way;
}

int PanelGraph::nearestTo(const Eigen::Vector3d& point) const {
	int nearest = -1;
	double least = std::numeric_limits<double>::infinity();
	for (int copy = 0; copy < surface_.assembly().copyCount(); ++copy) {
		if (!has(copy))
			continue;
		const double distance =
			(surface_.positions().col(surface_.assembly().placeOfCopy[copy]) - point).squaredNorm();
		if (distance < least) {
			least = distance;
			nearest = copy;
		}
	}
	return nearest;
}

} // namespace developable::detail
