// SPDX-License-Identifier: GPL-3.0-or-later
// panel_cuts.h: the short paths along which a panel with holes is cut open into a disk.
#pragma once

#include "panel_mesh.h"

#include <limits>
#include <queue>

namespace developable::detail {

/// Where to cut a panel. Each path is half edges, one of every edge of the path.
struct PanelCuts {
	std::vector<std::vector<int>> needed; ///< to holes that no flat sheet can have
	std::vector<std::vector<int>> atMost; ///< to the other holes: only a disk needs these
};

/// Finds paths inside a panel, one at a time, each from what is joined so far to the nearest boundary loop
/// that is not.
class CutFinder {
public:
	CutFinder(const PanelMesh& panel, const std::vector<std::vector<int>>& loops, int outerLoop)
		: panel_(panel), loops_(loops), loopOfVertex_(panel.vertexCount(), -1),
		  joined_(panel.vertexCount(), 0), firstEdge_(panel.vertexCount() + 1, 0) {
		for (std::size_t loop = 0; loop < loops.size(); ++loop)
			for (const int h : loops[loop])
				loopOfVertex_[panel.start(h)] = static_cast<int>(loop);
		join(loops[outerLoop]);
		// Half edges by their starts; those inside a panel come in pairs, so each edge is met from both ends.
		for (int h = 0; h < panel.halfEdgeCount(); ++h)
			++firstEdge_[panel.start(h) + 1];
		for (std::size_t vertex = 1; vertex < firstEdge_.size(); ++vertex)
			firstEdge_[vertex] += firstEdge_[vertex - 1];
		edges_.resize(panel.halfEdgeCount());
		std::vector<int> next(firstEdge_.begin(), firstEdge_.end() - 1);
		for (int h = 0; h < panel.halfEdgeCount(); ++h)
			edges_[next[panel.start(h)]++] = h;
	}

	/// The shortest path to one of these loops (Dijkstra), which is taken off the list; empty when other
	/// loops are in the way of them all.
	std::vector<int> nextPath(std::vector<int>& loops) {
		const int reached = search(loops);
		std::vector<int> path;
		if (reached < 0)
			return path;
		for (int vertex = reached; arrival_[vertex] >= 0; vertex = panel_.start(arrival_[vertex])) {
			path.push_back(arrival_[vertex]);
			joined_[vertex] = 1;
		}
		const int loop = loopOfVertex_[reached];
		join(loops_[loop]);
		loops.erase(std::find(loops.begin(), loops.end(), loop));
		return path;
	}

private:
	void join(const std::vector<int>& loop) {
		for (const int h : loop)
			joined_[panel_.start(h)] = 1;
	}

	/// Fills arrival_ with the half edge by which each vertex is reached; returns the vertex that was sought.
	int search(const std::vector<int>& loops) {
		using Reached = std::pair<double, int>;
		std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
		std::vector<double> distance(panel_.vertexCount(), std::numeric_limits<double>::infinity());
		arrival_.assign(panel_.vertexCount(), -1);
		for (int vertex = 0; vertex < panel_.vertexCount(); ++vertex)
			if (joined_[vertex])
				front.emplace(distance[vertex] = 0, vertex);
		while (!front.empty()) {
			const auto [far, vertex] = front.top();
			front.pop();
			const int loop = loopOfVertex_[vertex];
			if (!joined_[vertex] && loop >= 0 && std::find(loops.begin(), loops.end(), loop) != loops.end())
				return vertex;
			if (far > distance[vertex] || (!joined_[vertex] && loop >= 0))
				continue;
			for (int i = firstEdge_[vertex]; i < firstEdge_[vertex + 1]; ++i) {
				const int h = edges_[i], other = panel_.end(h);
				if (panel_.joinedHalfEdge[h] < 0 || far + panel_.length(h) >= distance[other])
					continue;
				distance[other] = far + panel_.length(h);
				arrival_[other] = h;
				front.emplace(distance[other], other);
			}
		}
		return -1;
	}

	const PanelMesh& panel_;
	const std::vector<std::vector<int>>& loops_;
	std::vector<int> loopOfVertex_;
	std::vector<char> joined_;
	std::vector<int> firstEdge_, edges_; // half edges by their starts
	std::vector<int> arrival_;
};

/// Chooses where to cut. A hole in a flat sheet turns by -2π in all; what it turns by beyond that is the
/// total curvature that it stands for (Gauss and Bonnet): 0 for a window in a sheet, 2π for the end of a
/// tube.
///
/// \param greatestCurvature  rad; a hole that stands for more is cut open in any case
inline PanelCuts chooseCuts(const PanelMesh& panel, const std::vector<std::vector<int>>& loops,
							double greatestCurvature) {
	const Eigen::VectorXd angles = angleSums(panel);
	std::vector<double> turning;
	for (const std::vector<int>& loop : loops) {
		double sum = 0;
		for (const int h : loop)
			sum += pi - angles[panel.start(h)];
		turning.push_back(sum);
	}
	const int outer = static_cast<int>(std::max_element(turning.begin(), turning.end()) - turning.begin());
	std::vector<int> tubes, windows;
	for (int loop = 0; loop < static_cast<int>(loops.size()); ++loop)
		if (loop != outer)
			(std::abs(turning[loop] + 2 * pi) > greatestCurvature ? tubes : windows).push_back(loop);
	CutFinder finder(panel, loops, outer);
	PanelCuts cuts;
	while (!tubes.empty()) {
		std::vector<int> path = finder.nextPath(tubes);
		if (path.empty()) // windows are in the way, so one of them is cut open too
			path = finder.nextPath(windows);
		cuts.needed.push_back(std::move(path));
	}
	while (!windows.empty())
		cuts.atMost.push_back(finder.nextPath(windows));
	return cuts;
}

} // namespace developable::detail
