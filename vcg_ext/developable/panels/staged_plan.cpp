// SPDX-License-Identifier: GPL-3.0-or-later
// staged_plan.cpp: panels that get more room from stage to stage.
#include "panel_plan.h"

#include "panel_joining.h"
#include "sewn_failures.h"

#include <utility>

namespace developable::detail {

/// Panels that move little by themselves leave room for what others do to them when all are sewn together:
/// the more there are that pull at each other, the more of it they need. What holds is carried on from the
/// seams that were joined, not from those that were drawn.
bool PanelPlan::searchInStages() {
	constexpr double rooms[] = {0.47, 0.6, 0.75};
	const bool confirms = std::exchange(confirms_, false);
	for (const double room : rooms) {
		if (!joinWithRoom(room) || tests_->stopped())
			break;
		planned_ = held_->undrawn;
	}
	confirms_ = confirms;
	room_ = 1;
	if (tests_->stopped())
		return false;
	if (held_) {
		planned_ = held_->drawn;
		dartTips_ = held_->dartTips;
		joinHeldWithDarts();
	}
	sewn_ = divideUntilAllHold();
	return finish();
}

/// \return whether all hold when they are sewn together, and there are no more than before
bool PanelPlan::joinWithRoom(double room) {
	constexpr int rounds = 6;
	room_ = room;
	workOnJoining_ = work();
	tests_->scaleLimits(room);
	history_.tryAllAgain();
	joinPanels(planned_.surface, *tests_, history_, [this](const SeamChain&) { return mayJoinOn(); });
	const std::optional<Held> before = std::exchange(held_, std::nullopt);
	const bool holds =
		sewUntilAllHold(rounds) && held_ &&
		(!before || held_->drawn.surface.usedPanelCount() <= before->drawn.surface.usedPanelCount());
	if (!holds)
		held_ = before;
	else if (before)
		earlier_.insert(earlier_.begin(), before->drawn);
	return holds;
}

/// As far as that holds briefly.
void PanelPlan::joinHeldWithDarts() {
	if (!options_.darts || !options_.splitTriangles || !mayTry())
		return;
	joinWithDarts(planned_.surface, *tests_, sewnExcess());
	if (worstOf(relieved(sewTogether(true), true)) >= 0)
		planned_ = held_->drawn;
}

} // namespace developable::detail
