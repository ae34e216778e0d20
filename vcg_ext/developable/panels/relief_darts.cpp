// SPDX-License-Identifier: GPL-3.0-or-later
// relief_darts.cpp: shortest paths within a panel.
#include "relief_darts.h"

#include "panel_graph.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

constexpr double leastEdges = 2.5; ///< of a dart

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
	const int point = graph.nearestTo(at);
	if (point < 0)
		return {};
	const PanelGraph::Paths depths = graph.fromBorder();
	const bool fromPoint = graph.onBorder(point);
	const PanelGraph::Paths paths = fromPoint ? graph.from({point}) : depths;
	int copy = fromPoint ? deepestWithin(graph, paths, depths, length) : point;
	if (copy < 0 || !paths.reach(copy))
		return {};
	Dart dart{paths.length[copy], surface.positions().col(surface.assembly().placeOfCopy[copy])};
	for (const int h : graph.wayTo(copy, paths))
		surface.setCut(h, true);
	return dart;
}

} // namespace developable::detail
