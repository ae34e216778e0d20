// SPDX-License-Identifier: GPL-3.0-or-later
// cut_report.cpp: panels in the order of the cut mesh, seams, the verdict and what would do.
#include "cut_report.h"

#include "seam_chains.h"

#include <algorithm>
#include <limits>

namespace developable::detail {

CutReport reportOf(const CutSurface& surface, const SewnPanels& sewn, double givenSeamLength,
				   const CutOptions& options) {
	CutReport report;
	report.meanDisplacement = sewn.meanDisplacement;
	report.maxDisplacement = sewn.maxDisplacement;
	report.smallestPanelArea = std::numeric_limits<double>::infinity();
	std::vector<int> number(surface.panelCount(), -1);
	for (int t = 0; t < surface.assembly().triangleCount(); ++t) { // panels are numbered as in the cut mesh
		const int panel = surface.panelOf(t);
		if (number[panel] >= 0)
			continue;
		number[panel] = static_cast<int>(report.panels.size());
		report.panels.push_back(sewn.panels[panel]);
		report.smallestPanelArea = std::min(report.smallestPanelArea, sewn.panels[panel].area);
	}
	for (CutPanel& panel : report.panels)
		if (panel.neighbour >= 0)
			panel.neighbour = number[panel.neighbour];
	report.seamLength = givenSeamLength;
	for (const SeamChain& chain : seamChains(surface)) {
		report.seamLength += chain.length;
		report.darts += chain.isDart();
	}
	const auto bad = std::count_if(report.panels.begin(), report.panels.end(),
								   [](const CutPanel& panel) { return !panel.developable; });
	const bool soFew = options.maxPanels > 0 && int(report.panels.size()) >= options.maxPanels;
	const bool uncut = seamChains(surface).empty();
	const bool tooMany = !uncut && soFew && int(report.panels.size()) > options.maxPanels;
	report.status = bad > 0                         ? (soFew ? Status::LimitReached : Status::NeedsCut)
					: tooMany                       ? Status::LimitReached
					: uncut && givenSeamLength == 0 ? Status::NothingToDo
													: Status::Converged;
	if (tooMany)
		report.notes.push_back("No way was found to make do with " +
							   counted(std::size_t(options.maxPanels), "panel", "panels") +
							   ": there are as few as could be joined.");
	if (bad > 0) {
		report.notes.push_back(
			counted(std::size_t(bad), "panel", "panels") + " of " + std::to_string(report.panels.size()) +
			" can't be made developable within the largest displacement: allow a larger one" +
			(soFew                  ? ", or more panels."
			 : options.keepSelected ? ", or select less to keep whole."
									: "."));
	}
	return report;
}

} // namespace developable::detail
