// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_failures.cpp: panels by how far they are from holding.
#include "sewn_failures.h"

#include "developable/newton/constrained_newton.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

namespace {

/// How bad it is that a panel is not developable, in any unit; 0 when it is.
double excess(const CutPanel& panel) {
	if (panel.triangles == 0 || panel.developable)
		return 0;
	constexpr double least = 1e-300; // what overlaps may not move at all
	return std::max(least, panel.maxDisplacement * (1 + panel.curvatureAfter));
}

} // namespace

bool overlaps(const CutPanel& panel) {
	return panel.triangles > 0 && !panel.developable && panel.reason == Reason::NeedsCut &&
		   panel.curvatureAfter <= ConstrainedNewtonOptions().curvatureTolerance;
}

bool wantsDart(const CutPanel& panel) {
	return excess(panel) > 0 && panel.reason != Reason::BeyondBounds && !overlaps(panel);
}

double totalExcess(const SewnPanels& sewn) {
	double sum = 0;
	for (const CutPanel& panel : sewn.panels)
		sum += excess(panel);
	return sum;
}

std::vector<int> worstFirst(const SewnPanels& sewn) {
	std::vector<int> panels;
	for (int panel = 0; panel < static_cast<int>(sewn.panels.size()); ++panel)
		if (excess(sewn.panels[panel]) > 0)
			panels.push_back(panel);
	std::stable_sort(panels.begin(), panels.end(),
					 [&](int a, int b) { return excess(sewn.panels[a]) > excess(sewn.panels[b]); });
	return panels;
}

std::vector<int> panelsToDivide(const SewnPanels& sewn) {
	std::vector<int> failing = worstFirst(sewn);
	const auto isForItself = [&](int panel) {
		return overlaps(sewn.panels[panel]) || sewn.panels[panel].reason == Reason::BeyondBounds;
	};
	if (std::any_of(failing.begin(), failing.end(), isForItself) || failing.empty())
		return failing;
	const double tolerance = ConstrainedNewtonOptions().curvatureTolerance;
	const auto badness = [&](int panel) {
		const CutPanel& report = sewn.panels[panel];
		return std::make_pair(std::max(report.curvatureAfter - tolerance, 0.0), report.maxDisplacement);
	};
	return {*std::max_element(failing.begin(), failing.end(),
							  [&](int a, int b) { return badness(a) < badness(b); })};
}

std::vector<int> panelsToDivideIn(int round, bool mayTry, const SewnPanels& sewn) {
	constexpr int roundsOfOne = 8, roundsOfSome = 14;
	constexpr std::size_t some = 3; // of so many the worst
	if (round < roundsOfOne && mayTry)
		return panelsToDivide(sewn);
	std::vector<int> panels = worstFirst(sewn);
	const auto count = static_cast<std::size_t>(std::count_if(
		sewn.panels.begin(), sewn.panels.end(), [](const CutPanel& panel) { return panel.triangles > 0; }));
	if (round < roundsOfSome && (mayTry || 2 * panels.size() <= count))
		panels.resize((panels.size() + some - 1) / some);
	return panels;
}

bool onlyOverlap(const SewnPanels& sewn) {
	const std::vector<int> failing = worstFirst(sewn);
	return !failing.empty() && std::all_of(failing.begin(), failing.end(),
										   [&](int panel) { return overlaps(sewn.panels[panel]); });
}

int worstOf(const SewnPanels& sewn) {
	const std::vector<int> panels = worstFirst(sewn);
	return panels.empty() ? -1 : panels.front();
}

std::vector<Eigen::Vector3d> worstPoints(const SewnPanels& sewn) {
	std::vector<Eigen::Vector3d> points;
	for (int panel = 0; panel < static_cast<int>(sewn.panels.size()); ++panel)
		if (excess(sewn.panels[panel]) > 0)
			points.push_back(sewn.panels[panel].worstPoint);
	for (const auto& [panel, overlap] : sewn.overlaps)
		points.push_back(overlap[1]); // the first is its worst
	return points;
}

} // namespace developable::detail
