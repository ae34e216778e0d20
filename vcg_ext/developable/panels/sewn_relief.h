// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_relief.h: darts where panels that are sewn together just fail to hold.
#pragma once

#include "panel_tests.h"
#include "planned_surface.h"
#include "relief_darts.h"
#include "sewn_panels.h"

#include <functional>
#include <set>

namespace developable::detail {

/// Panels that just fail to hold get darts where they do. A dart that makes it worse is taken out again, and
/// a longer one is tried; one that makes its panel overlap itself when laid flat is taken out for good, for
/// the surface is a saddle there. Where darts do not help in the end all of them go.
class SewnRelief {
public:
	using Sewing = std::function<SewnPanels()>; ///< of the surface as it is

	/// \param tips      of darts: gets those that stay
	/// \param workLeft  on sewing all together, in units of WorkBudget
	SewnRelief(PlannedSurface& planned, const CutOptions& options, const PanelTests& tests,
			   std::vector<Eigen::Vector3d>& tips, double& workLeft, Sewing sew);

	/// \param sewn  the surface as it is
	/// \return      the surface as it is afterwards
	SewnPanels relieved(SewnPanels sewn);

private:
	/// One more dart in each panel that may hold with it, or in the worst only.
	struct Round {
		double length = firstDartLength;
		bool onlyWorst = false;
	};

	/// \return whether it got better: then the surface has the darts
	bool tryRound(const Round& round, SewnPanels& sewn);
	/// \return the panels that got one
	std::set<int> addDarts(const Round& round, const SewnPanels& sewn);
	/// \return whether any of these do now and did not before: these get no dart any more
	bool overlapNow(const std::set<int>& panels, const SewnPanels& before, const SewnPanels& now);

	PlannedSurface& planned_;
	const std::vector<char> held_; // per triangle
	const PanelTests& tests_;      // which know of a stop
	std::vector<Eigen::Vector3d>& tips_;
	double& workLeft_;
	const Sewing sew_;
	std::vector<Eigen::Vector3d> tipsOfRound_;
	std::set<int> withoutDarts_;
};

} // namespace developable::detail
