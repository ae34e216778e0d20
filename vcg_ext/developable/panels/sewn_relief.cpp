// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_relief.cpp: rounds of darts, each seen by sewing all panels together.
#include "sewn_relief.h"

#include "selected_whole.h"
#include "sewn_failures.h"

namespace developable::detail {

SewnRelief::SewnRelief(PlannedSurface& planned, const CutOptions& options, const PanelTests& tests,
					   std::vector<Eigen::Vector3d>& tips, double& workLeft, Sewing sew)
	: planned_(planned), held_(keptTriangles(planned, options)), tests_(tests), tips_(tips),
	  workLeft_(workLeft), sew_(std::move(sew)) {}

SewnPanels SewnRelief::relieved(SewnPanels sewn) {
	constexpr int rounds = 8, patience = 3; // rounds that make it no better
	constexpr double increase = 1.6;        // of a dart's length after one of these
	const CutSurface start = planned_.surface;
	SewnPanels sewnAtStart = sewn;
	const std::size_t tipsAtStart = tips_.size();
	Round round;
	int idle = 0;
	for (int i = 0; i < rounds && idle < patience && workLeft_ > 0 && !tests_.stopped() && worstOf(sewn) >= 0;
		 ++i) {
		if (tryRound(round, sewn)) {
			idle = 0;
			round = {};
		} else if (tipsOfRound_.empty()) {
			break;
		} else {
			++idle;
			round = {round.length * increase, true};
		}
	}
	if (worstOf(sewn) < 0)
		return sewn;
	planned_.surface = start;
	tips_.resize(tipsAtStart);
	return sewnAtStart;
}

bool SewnRelief::tryRound(const Round& round, SewnPanels& sewn) {
	constexpr double better = 0.95; // share of the excess that a round may leave
	const CutSurface before = planned_.surface;
	while (true) {
		const std::set<int> panels = addDarts(round, sewn);
		if (panels.empty() || workLeft_ <= 0)
			break;
		SewnPanels next = sew_();
		workLeft_ -= next.work;
		if (tests_.stopped())
			break;
		if (!overlapNow(panels, sewn, next)) {
			if (totalExcess(next) >= better * totalExcess(sewn))
				break;
			tips_.insert(tips_.end(), tipsOfRound_.begin(), tipsOfRound_.end());
			sewn = std::move(next);
			return true;
		}
		planned_.surface = before;
	}
	planned_.surface = before;
	return false;
}

std::set<int> SewnRelief::addDarts(const Round& round, const SewnPanels& sewn) {
	std::set<int> panels;
	tipsOfRound_.clear();
	const int worst = worstOf(sewn);
	for (int panel = 0; panel < planned_.surface.panelCount(); ++panel) {
		if (!wantsDart(sewn.panels[panel]) || (round.onlyWorst && panel != worst) ||
			withoutDarts_.count(panel) > 0)
			continue;
		const Dart dart =
			cutDart(planned_.surface, panel, sewn.panels[panel].worstPoint, round.length, held_);
		if (dart.length > 0) {
			tipsOfRound_.push_back(dart.tip);
			panels.insert(panel);
		}
	}
	return panels;
}

bool SewnRelief::overlapNow(const std::set<int>& panels, const SewnPanels& before, const SewnPanels& now) {
	const std::size_t count = withoutDarts_.size();
	for (const int panel : panels)
		if (overlaps(now.panels[panel]) && !overlaps(before.panels[panel]))
			withoutDarts_.insert(panel);
	return withoutDarts_.size() > count;
}

} // namespace developable::detail
