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
	PanelPlan(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
			  const Progress& progress);

	CutResult run();

private:
	std::vector<double> maxDisplacements() const;

	/// Patches that are no panels become clusters of normals, each of which is one.
	void makeClusters();
	void tidyClusters();
	void divideUntilFlat();
	bool divideInTwo(int panel);
	void joinToSoFew();

	SewnPanels sewTogether(bool brief);
	SewnExcess sewnExcess();
	SewnPanels joinedWithDarts();
	SewnPanels divideUntilAllHold();
	void joinUntilAllHold();
	bool sewUntilAllHold(int rounds);
	bool takeBackLastJoins(CutSurface& surface, const PlannedSurface& joined,
						   const std::vector<int>& failing);
	bool divideOverlapping(CutSurface& surface, const PlannedSurface& joined, const SewnPanels& sewn);
	bool takeBackLastJoin(CutSurface& surface, int panel);
	int panelBefore(const PlannedSurface& before, int panel) const;
	SewnPanels relieved(SewnPanels sewn);
	SewnPanels smoothSeams();
	Progress progressOfRest();

	const CutOptions options_;
	const GivenPatches given_;
	PlannedSurface planned_;
	std::unique_ptr<PanelTests> tests_;
	std::vector<int> clusters_; // per triangle, before any were joined
	/// Sewing all panels together takes long: so often at most in each stage to see whether darts help.
	static constexpr int mostReliefs = 12;
	int reliefsLeft_ = mostReliefs;
	std::vector<Eigen::Vector3d> dartTips_;
	JoinHistory history_;
};

} // namespace developable::detail
