// SPDX-License-Identifier: GPL-3.0-or-later
// small_panels.cpp: a front that grows from a small panel into a neighbour.
#include "small_panels.h"

#include "seam_chains.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>

namespace developable::detail {

namespace {

constexpr double sliverShare = 0.2; ///< of the least share
constexpr double grown = 1.3;       ///< times the least share: seams that are drawn anew take a little

double leastAreaOf(const CutSurface& surface, int panel) {
	const int patch = surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()];
	return leastPanelShare * surface.patchArea(patch);
}

/// Triangles of a neighbour, nearest first, until a panel is large enough with them.
std::set<int> takenFrom(const CutSurface& surface, int panel, const std::vector<int>& seam,
						const std::vector<char>& held) {
	const double wanted = grown * leastAreaOf(surface, panel);
	double area = surface.area(panel);
	using Step = std::pair<double, int>; // length so far, triangle
	std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
	for (const int h : seam)
		steps.emplace(
			(surface.barycentre(triangleOf(surface.assembly().across(h))) - surface.middleOf(h)).norm(),
			triangleOf(surface.assembly().across(h)));
	std::set<int> taken;
	while (!steps.empty() && area < wanted) {
		const auto [length, triangle] = steps.top();
		steps.pop();
		if ((!held.empty() && held[triangle]) || !taken.insert(triangle).second)
			continue;
		area += surface.areas()[triangle];
		for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
			if (surface.across(h) >= 0) {
				const int next = triangleOf(surface.across(h));
				steps.emplace(length + (surface.barycentre(next) - surface.barycentre(triangle)).norm(),
							  next);
			}
	}
	return area < wanted ? std::set<int>() : taken;
}

/// \return whether both are panels then
bool growInto(CutSurface& surface, PanelTests& tests, int panel, int neighbour,
			  const std::vector<char>& held) {
	const std::vector<int> seam = halfEdgesBetween(surface, panel, neighbour);
	std::set<int> own = takenFrom(surface, panel, seam, held);
	if (own.empty())
		return false;
	own.insert(surface.trianglesOf(panel).begin(), surface.trianglesOf(panel).end());
	CutSurface next = surface;
	const std::set<int> panels = divideAnew(next, seam, own);
	if (panels.size() != 2)
		return false;
	std::vector<PanelTrial> trials;
	for (const int one : panels) {
		if (next.area(one) < leastAreaOf(next, one))
			return false;
		trials.push_back(trialOf(next, next.trianglesOf(one)));
	}
	if (!tests.areAllPanels(trials))
		return false;
	surface = std::move(next);
	return true;
}

double borderBetween(const CutSurface& surface, int panel, int other) {
	double length = 0;
	for (const int h : halfEdgesBetween(surface, panel, other))
		length += surface.length(h);
	return length;
}

/// \return whether it did
bool joinTo(CutSurface& surface, PanelTests& tests, JoinHistory& history, int panel, int neighbour) {
	constexpr double room = 1.3; // beside what a panel may need by itself
	const std::vector<int> seam = halfEdgesBetween(surface, panel, neighbour);
	const PanelTrial trial = trialAcross(surface, seam);
	PanelLimits limits = tests.limitsOf(trial.patch);
	limits.maxDisplacement *= room;
	limits.meanDisplacement *= room;
	if (!testPanel(trial.panel, limits).isPanel())
		return false;
	history.join(surface, seam);
	return true;
}

} // namespace

void joinSlivers(CutSurface& surface, PanelTests& tests, JoinHistory& history) {
	for (const int panel : smallPanels(surface)) {
		if (surface.trianglesOf(panel).empty() ||
			surface.area(panel) > sliverShare * leastAreaOf(surface, panel))
			continue;
		std::vector<int> neighbours = neighboursOf(surface, panel);
		std::stable_sort(neighbours.begin(), neighbours.end(), [&](int a, int b) {
			return borderBetween(surface, panel, a) > borderBetween(surface, panel, b);
		});
		for (const int neighbour : neighbours)
			if (tests.stopped() || joinTo(surface, tests, history, panel, neighbour))
				break;
	}
}

std::vector<int> neighboursOf(const CutSurface& surface, int panel) {
	std::set<int> found;
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (surface.assembly().across(h) >= 0)
				found.insert(surface.panelOf(triangleOf(surface.assembly().across(h))));
	found.erase(panel);
	std::vector<int> neighbours(found.begin(), found.end());
	std::stable_sort(neighbours.begin(), neighbours.end(),
					 [&](int a, int b) { return surface.area(a) > surface.area(b); });
	return neighbours;
}

std::vector<int> halfEdgesBetween(const CutSurface& surface, int panel, int other) {
	std::vector<int> halfEdges;
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (surface.assembly().across(h) >= 0 &&
				surface.panelOf(triangleOf(surface.assembly().across(h))) == other)
				halfEdges.push_back(h);
	return halfEdges;
}

std::set<int> divideAnew(CutSurface& surface, const std::vector<int>& seam, const std::set<int>& own) {
	const int both = surface.join(seam);
	const std::vector<int> triangles = surface.trianglesOf(both);
	std::vector<int> labels;
	labels.reserve(triangles.size());
	for (const int t : triangles)
		labels.push_back(own.count(t) > 0);
	surface.divide(both, labels);
	std::set<int> panels;
	for (const int t : triangles)
		panels.insert(surface.panelOf(t));
	return panels;
}

std::vector<int> smallPanels(const CutSurface& surface) {
	std::vector<int> small;
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (!surface.trianglesOf(panel).empty() && surface.area(panel) < leastAreaOf(surface, panel))
			small.push_back(panel);
	std::stable_sort(small.begin(), small.end(),
					 [&](int a, int b) { return surface.area(a) < surface.area(b); });
	return small;
}

void growSmallPanels(CutSurface& surface, PanelTests& tests, const std::vector<char>& held) {
	for (const int panel : smallPanels(surface)) {
		if (surface.trianglesOf(panel).empty())
			continue; // it went to another that grew
		for (const int neighbour : neighboursOf(surface, panel))
			if (tests.stopped() || growInto(surface, tests, panel, neighbour, held))
				break;
	}
}

} // namespace developable::detail
