// SPDX-License-Identifier: GPL-3.0-or-later
// relief_darts.cpp: shortest paths within a panel.
#include "relief_darts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace developable::detail {

namespace {

constexpr double leastEdges = 2.5; ///< of a dart
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The copies of a panel with the half edges between them that are not cut.
class PanelGraph {
public:
	PanelGraph(const CutSurface& surface, int panel, const std::vector<char>& held) : surface_(surface) {
		const int copies = surface.assembly().copyCount();
		inside_.assign(copies, 0);
		std::vector<std::pair<int, int>> ends; // copy and half edge
		for (const int t : surface.trianglesOf(panel))
			for (int h = 3 * t; h < 3 * t + 3; ++h) {
				inside_[surface.startOf(h)] = 1;
				if (surface.across(h) >= 0 && surface.across(h) > h)
					continue; // once
				if (surface.across(h) >= 0 && !held.empty() && held[t] && held[triangleOf(surface.across(h))])
					continue;
				if (surface.across(h) >= 0) {
					ends.emplace_back(surface.startOf(h), h);
					ends.emplace_back(surface.endOf(h), h);
				} else {
					border_.push_back(surface.startOf(h));
					border_.push_back(surface.endOf(h));
				}
			}
		onBorder_.assign(copies, 0);
		for (const int copy : border_)
			onBorder_[copy] = 1;
		halfEdges_.resize(copies);
		for (const auto& [copy, h] : ends)
			halfEdges_[copy].push_back(h);
	}

	bool has(int copy) const { return inside_[copy] != 0; }
	bool onBorder(int copy) const { return onBorder_[copy] != 0; }

	/// Shortest paths from some copies, over copies inside the panel.
	struct Paths {
		std::vector<double> length; ///< per copy
		std::vector<int> halfEdge;  ///< per copy, of the step to it; -1 at the beginning
	};

	Paths from(const std::vector<int>& copies) const {
		Paths paths{std::vector<double>(inside_.size(), infinite), std::vector<int>(inside_.size(), -1)};
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

	Paths fromBorder() const { return from(border_); }

	int otherEnd(int h, int copy) const {
		return surface_.startOf(h) == copy ? surface_.endOf(h) : surface_.startOf(h);
	}

private:
	const CutSurface& surface_;
	std::vector<char> inside_, onBorder_; // per copy
	std::vector<int> border_;
	std::vector<std::vector<int>> halfEdges_; // per copy
};

int nearestCopy(const CutSurface& surface, const PanelGraph& graph, const Eigen::Vector3d& at) {
	int nearest = -1;
	double least = infinite;
	for (int copy = 0; copy < surface.assembly().copyCount(); ++copy) {
		if (!graph.has(copy))
			continue;
		const double distance =
			(surface.positions().col(surface.assembly().placeOfCopy[copy]) - at).squaredNorm();
		if (distance < least) {
			least = distance;
			nearest = copy;
		}
	}
	return nearest;
}

/// The copy that is deepest inside, of those that a path of some length reaches, and of equals the nearest;
/// -1: none.
int deepestWithin(const PanelGraph& graph, const PanelGraph::Paths& paths, const PanelGraph::Paths& depths,
				  double length) {
	int deepest = -1;
	const auto isDeeper = [&](int a, int b) {
		const double difference = depths.length[a] - depths.length[b];
		const bool equal = std::abs(difference) < 1e-6 * depths.length[b];
		return equal ? paths.length[a] < paths.length[b] : difference > 0;
	};
	for (int copy = 0; copy < static_cast<int>(paths.length.size()); ++copy)
		if (graph.has(copy) && !graph.onBorder(copy) && paths.length[copy] <= length &&
			(deepest < 0 || isDeeper(copy, deepest)))
			deepest = copy;
	return deepest;
}

} // namespace

Dart cutDart(CutSurface& surface, int panel, const Eigen::Vector3d& at, double share,
			 const std::vector<char>& held) {
	const double length =
		std::max(share * std::sqrt(surface.area(panel)), leastEdges * meanEdgeLength(surface.assembly()));
	const PanelGraph graph(surface, panel, held);
	const int point = nearestCopy(surface, graph, at);
	if (point < 0)
		return {};
	const PanelGraph::Paths depths = graph.fromBorder();
	const bool fromPoint = graph.onBorder(point);
	const PanelGraph::Paths paths = fromPoint ? graph.from({point}) : depths;
	int copy = fromPoint ? deepestWithin(graph, paths, depths, length) : point;
	if (copy < 0 || paths.length[copy] == infinite)
		return {};
	Dart dart{paths.length[copy], surface.positions().col(surface.assembly().placeOfCopy[copy])};
	while (paths.halfEdge[copy] >= 0) {
		surface.setCut(paths.halfEdge[copy], true);
		copy = graph.otherEnd(paths.halfEdge[copy], copy);
	}
	return dart;
}

} // namespace developable::detail
