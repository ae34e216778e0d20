// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.h: from patches to panels: clusters, joining, smooth seams, darts, and all sewn together.
#pragma once

#include "cut_into_panels.h"
#include "panel_joining.h"
#include "planned_surface.h"
#include "sewn_panels.h"

#include <memory>

namespace developable::detail {

class PanelPlan {
public:
	PanelPlan(GivenPatches given, const CutOptions& options, const Progress& progress);

	CutResult run();

private:
	std::vector<double> maxDisplacements() const;
	void joinToSoFew();

	void joinUntilAllHold();
	bool sewUntilAllHold(int rounds);
	std::vector<char> divideFailing(PlannedSurface& before, const SewnPanels& sewn);
	SewnPanels joinedWithDarts();
	SewnPanels divideUntilAllHold();

	SewnPanels sewTogether(bool brief);
	SewnExcess sewnExcess();
	SewnPanels smoothSeams();
	SewnPanels relieved(SewnPanels sewn);
	Progress progressOfRest();

	const CutOptions options_;
	const GivenPatches given_;
	PlannedSurface planned_;
	std::unique_ptr<PanelTests> tests_;
	std::vector<int> clusters_; // per triangle, before any were joined
	/// Sewing all panels together takes long: so often at most in each stage to see whether darts help.
	static constexpr int mostReliefs = 12;
	int reliefsLeft_ = mostReliefs;
	int sewingsLeft_ = 30; // until what does not hold is just divided
	std::vector<Eigen::Vector3d> dartTips_;
	JoinHistory history_;
};

} // namespace developable::detail
