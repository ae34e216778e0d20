// SPDX-License-Identifier: GPL-3.0-or-later
// symmetric_plan.cpp: the stages of the work where left mirrors right.
#include "panel_plan.h"

#include "first_panels.h"
#include "normal_clusters.h"
#include "selected_whole.h"
#include "sewn_failures.h"
#include "symmetric_joining.h"
#include "taken_back_joins.h"

#include <cmath>
#include <set>

namespace developable::detail {

SymmetricOutcome PanelPlan::searchSymmetric(const MirrorPlane& plane) {
	constexpr int rounds = 12;
	constexpr double tighter = 0.95; // with every round, as where nothing mirrors anything
	mirror_ = &plane;
	tests_->refuseNotches(); // to close them is a matter of one side
	const std::vector<int> mirrored = mirroredTriangles(planned_.mesh, plane);
	makeFirstPanels(planned_, *tests_, options_, ClusterOptions().greatestDeviation);
	CutSurface& surface = planned_.surface;
	surface.relabel(surface.withoutFragments(
		withSelectedWhole(planned_, options_, symmetricLabels(surface, plane, mirrored))));
	clusters_ = surface.panels();
	for (int round = 0; round < rounds && !tests_->stopped(); ++round) {
		tests_->scaleLimits(std::pow(tighter, round));
		joinSymmetrically(planned_.surface, *tests_, history_, plane, mirrored);
		workOnJoining_ = round == 0 ? work() : workOnJoining_;
		PlannedSurface joined = planned_;
		sewn_ = smoothSeams();
		std::set<int> failing;
		for (const int panel : worstFirst(sewn_))
			failing.insert(panelBefore(joined, planned_, panel));
		if (failing.empty() ||
			!takeBackSymmetrically(joined.surface, {failing.begin(), failing.end()}, history_, mirrored))
			break;
		if (round + 1 < rounds)
			planned_ = std::move(joined);
	}
	if (worstOf(sewn_) < 0 && worstOf(sewn_ = sewTogether(false)) < 0)
		return SymmetricOutcome::Pairs;
	sewn_ = divideUntilAllHold();
	return worstOf(sewn_) < 0 ? SymmetricOutcome::Divided : SymmetricOutcome::Fails;
}

} // namespace developable::detail
