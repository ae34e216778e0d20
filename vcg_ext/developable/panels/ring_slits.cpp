// SPDX-License-Identifier: GPL-3.0-or-later
// ring_slits.cpp: shortest paths from each border to the others.
#include "ring_slits.h"

#include "panel_graph.h"

#include <limits>
#include <map>
#include <set>

namespace developable::detail {

namespace {

struct Slit {
	double length = std::numeric_limits<double>::infinity();
	std::vector<int> halfEdges;
};

/// The copies on each border of a panel; cuts are borders, too.
std::vector<std::vector<int>> bordersOf(const CutSurface& surface, int panel) {
	std::vector<int> onBorder;
	DisjointSets connected(surface.assembly().copyCount());
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (surface.across(h) < 0) {
				connected.unite(surface.startOf(h), surface.endOf(h));
				onBorder.push_back(surface.startOf(h));
				onBorder.push_back(surface.endOf(h));
			}
	std::map<int, std::vector<int>> borders;
	for (const int copy : onBorder)
		borders[connected.find(copy)].push_back(copy);
	std::vector<std::vector<int>> result;
	result.reserve(borders.size());
	for (auto& [root, copies] : borders)
		result.push_back(std::move(copies));
	return result;
}

/// From a border to another: along one edge or over copies inside.
Slit shortestFrom(const CutSurface& surface, int panel, const PanelGraph& graph,
				  const std::vector<int>& border) {
	std::vector<char> own(surface.assembly().copyCount(), 0);
	for (const int copy : border)
		own[copy] = 1;
	Slit shortest;
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h) {
			const int end = surface.endOf(h);
			if (surface.across(h) >= 0 && own[surface.startOf(h)] && graph.onBorder(end) && !own[end] &&
				surface.length(h) < shortest.length)
				shortest = {surface.length(h), {h}};
		}
	const PanelGraph::Paths paths = graph.from(border);
	for (int copy = 0; copy < static_cast<int>(own.size()); ++copy)
		if (graph.has(copy) && graph.onBorder(copy) && !own[copy] && paths.length[copy] < shortest.length)
			shortest = {paths.length[copy], graph.wayTo(copy, paths)};
	return shortest;
}

} // namespace

void slitHoles(CutSurface& surface, int panel, int euler) {
	for (int now = eulerCharacteristic(surface, panel); now < euler; ++now) {
		const PanelGraph graph(surface, panel, {});
		Slit shortest;
		for (const std::vector<int>& border : bordersOf(surface, panel)) {
			Slit slit = shortestFrom(surface, panel, graph, border);
			if (slit.length < shortest.length)
				shortest = std::move(slit);
		}
		for (const int h : shortest.halfEdges)
			surface.setCut(h, true);
	}
}

void slitPanelsOf(CutSurface& surface, const std::vector<int>& triangles) {
	std::set<int> panels;
	for (const int t : triangles)
		panels.insert(surface.panelOf(t));
	for (const int panel : panels)
		slitHoles(surface, panel);
}

} // namespace developable::detail
