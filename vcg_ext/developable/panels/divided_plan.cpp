// SPDX-License-Identifier: GPL-3.0-or-later
// divided_plan.cpp: panels that do not hold when they are sewn together become two, or what they were joined
// of.
#include "panel_plan.h"

#include "first_panels.h"
#include "ring_slits.h"
#include "selected_whole.h"
#include "sewn_failures.h"
#include "small_panels.h"
#include "taken_back_joins.h"

#include <algorithm>
#include <map>
#include <utility>

namespace developable::detail {

/// \return whether there are two panels for one now, or more
bool PanelPlan::divideByNormals(int panel) {
	const std::vector<int> triangles = planned_.surface.trianglesOf(panel);
	if (triangles.size() < 2 || !divideInTwo(planned_, options_, panel))
		return false;
	slitPanelsOf(planned_.surface, triangles);
	return true;
}

/// Of panels that all hold but that some overlap themselves as the user will have it. Seen briefly others
/// might, and so they are not. The method may end far from where it did with other seams: then the same
/// panels are divided elsewhere.
SewnPanels PanelPlan::divideOverlapsOf(const SewnPanels& sewn) {
	const PlannedSurface before = planned_;
	for (const int panel : worstFirst(sewn))
		if (sewn.overlaps.count(panel) == 0)
			divideByNormals(panel);
	divideOverlapping(planned_.surface, sewn.overlaps, history_);
	SewnPanels next = sewTogether(false);
	if (worstOf(next) < 0 || onlyOverlap(next) || tests_->stopped())
		return next;
	PlannedSurface divided = std::exchange(planned_, before);
	for (const int panel : worstFirst(sewn))
		divideByNormals(panel);
	SewnPanels other = sewTogether(false);
	if (worstFirst(other).size() < worstFirst(next).size())
		return other;
	planned_ = std::move(divided);
	return next;
}

/// Divides in two what does not hold together, where darts do not help.
SewnPanels PanelPlan::divideUntilAllHold() {
	constexpr int rounds = 32;
	reliefsLeft_ = workOnReliefs;
	closingsLeft_ = workOnClosings;
	SewnPanels sewn = confirmed(relieved(sewTogether(true), true));
	for (int round = 0; round < rounds && !tests_->stopped(); ++round) {
		if (!sewn.provisional && onlyOverlap(sewn)) {
			sewn = divideOverlapsOf(sewn);
			continue;
		}
		bool any = divideOverlapping(planned_.surface, sewn.overlaps, history_);
		for (const int panel : panelsToDivideIn(round, mayTry(), sewn))
			any = (sewn.overlaps.count(panel) == 0 && divideByNormals(panel)) || any;
		if (!any)
			break;
		growSmallPanels(planned_.surface, *tests_, keptTriangles(planned_, options_));
		sewn = confirmed(relieved(sewTogether(true), true));
	}
	return sewn;
}

/// What did not hold. Where panels only overlap themselves the others stay as they are.
/// \param before  its seams were drawn
/// \return        per triangle whether its panel may be joined anew; empty when nothing could be divided
std::vector<char> PanelPlan::divideFailing(PlannedSurface& before, const SewnPanels& sewn) {
	std::vector<int> panels;
	std::map<int, std::array<Eigen::Vector3d, 2>> overlaps;
	for (const int panel : panelsToDivide(sewn)) {
		const int failing = panelBefore(before, planned_, panel);
		if (std::find(panels.begin(), panels.end(), failing) == panels.end())
			panels.push_back(failing);
		if (sewn.overlaps.count(panel) > 0)
			overlaps[failing] = sewn.overlaps.at(panel);
	}
	std::vector<char> mayJoin(clusters_.size(), 1);
	if (overlaps.size() < panels.size()) {
		if (takeBackLastJoins(before.surface, panels, history_))
			return mayJoin;
		if (!divideClusters(before, panels))
			return {};
	} else {
		for (std::size_t t = 0; t < mayJoin.size(); ++t)
			mayJoin[t] = overlaps.count(before.surface.panelOf(static_cast<int>(t))) > 0;
		if (!divideOverlapping(before.surface, overlaps, history_) && !divideClusters(before, panels))
			return {};
	}
	std::map<std::pair<int, int>, int> numbers; // a cluster may have been divided, too
	for (std::size_t t = 0; t < clusters_.size(); ++t)
		clusters_[t] = numbers
						   .emplace(std::make_pair(clusters_[t], before.surface.panelOf(static_cast<int>(t))),
									int(numbers.size()))
						   .first->second;
	return mayJoin;
}

/// Panels that were joined of nothing, or overlap themselves within a triangle. \return whether any could be
/// divided
bool PanelPlan::divideClusters(PlannedSurface& before, const std::vector<int>& panels) {
	bool any = false;
	for (const int panel : panels) {
		history_.neverAgain(before.surface, panel);
		any = divideInTwo(before, options_, panel) || any;
	}
	return any;
}

} // namespace developable::detail
