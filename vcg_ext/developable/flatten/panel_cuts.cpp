// SPDX-License-Identifier: GPL-3.0-or-later
// panel_cuts.cpp: which boundary loops are cut open, and the shortest paths between them.
#include "panel_cuts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace developable::detail {

namespace {

/// Finds paths inside a panel, one at a time, each from what is joined so far to the nearest boundary loop
/// that is not.
class CutFinder {
public:
	CutFinder(const PanelMesh& panel, const std::vector<std::vector<int>>& loops, int outerLoop)
		: panel_(panel), loops_(loops), loopOfVertex_(panel.vertexCount(), -1),
		  joined_(panel.vertexCount(), 0), outgoing_(grouped(panel.vertexCount(), panel.halfEdgeCount(),
															 [&](int h) { return panel.start(h); })) {
		for (std::size_t loop = 0; loop < loops.size(); ++loop)
			for (const int h : loops[loop])
				loopOfVertex_[panel.start(h)] = static_cast<int>(loop);
		join(loops[outerLoop]);
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
			for (const int* edge = outgoing_.begin(vertex); edge != outgoing_.end(vertex); ++edge) {
				const int h = *edge, other = panel_.end(h);
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
	Groups outgoing_; // half edges by their starts; each edge inside a panel is met from both ends
	std::vector<int> arrival_;
};

} // namespace

PanelCuts chooseCuts(const PanelMesh& panel, const std::vector<std::vector<int>>& loops,
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
