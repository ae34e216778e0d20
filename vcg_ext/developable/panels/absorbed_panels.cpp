// SPDX-License-Identifier: GPL-3.0-or-later
// absorbed_panels.cpp: what is too small when all panels hold.
#include "panel_plan.h"

#include "panel_test.h"
#include "selected_whole.h"
#include "sewn_failures.h"
#include "small_panels.h"

namespace developable::detail {

/// What is too small goes to a neighbour, or takes from one, if all hold then. Whole runs take long: one
/// shows whether all that holds briefly does, and where it does not, some more do so one by one.
void PanelPlan::absorbSmallPanels() {
	constexpr int manyTries = 8, fewTries = 4, wholeTries = 2;
	const int briefTries = mayTry() ? manyTries : fewTries;
	if (!confirms_ || smallPanels(planned_.surface).empty() || worstOf(sewn_) >= 0) {
		absorbEach(briefTries);
		return;
	}
	const PlannedSurface before = planned_;
	const SewnPanels sewn = sewn_;
	confirms_ = false;
	absorbEach(briefTries);
	confirms_ = true;
	sewn_ = sewTogether(false);
	if (worstOf(sewn_) < 0 || tests_->stopped())
		return;
	planned_ = before;
	sewn_ = sewn;
	if (mayTry())
		absorbEach(wholeTries);
}

/// \param tries  of sewing all together
void PanelPlan::absorbEach(int tries) {
	for (const int panel : smallPanels(planned_.surface)) {
		bool done = worstOf(sewn_) >= 0;
		for (const int neighbour : neighboursOf(planned_.surface, panel))
			done = done || tests_->stopped() || --tries < 0 || absorb(panel, neighbour);
	}
	if (worstOf(sewn_) >= 0 || tests_->stopped() || smallPanels(planned_.surface).empty())
		return;
	CutSurface grown = planned_.surface;
	growSmallPanels(grown, *tests_, keptTriangles(planned_, options_));
	keepIfAllHold(std::move(grown));
}

bool PanelPlan::absorb(int panel, int neighbour) {
	CutSurface joined = planned_.surface;
	const int both = joined.join(halfEdgesBetween(joined, panel, neighbour));
	return isDisk(joined.meshOf(joined.trianglesOf(both))) && keepIfAllHold(std::move(joined));
}

bool PanelPlan::keepIfAllHold(CutSurface changed) {
	std::swap(planned_.surface, changed);
	SewnPanels sewn = sewTogether(true);
	if (confirms_ && worstOf(sewn) < 0 && sewn.provisional)
		sewn = sewTogether(false);
	const bool holds = worstOf(sewn) < 0;
	if (holds)
		sewn_ = std::move(sewn);
	else
		std::swap(planned_.surface, changed);
	return holds;
}

} // namespace developable::detail
