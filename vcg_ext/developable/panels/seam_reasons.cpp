// SPDX-License-Identifier: GPL-3.0-or-later
// seam_reasons.cpp: one trial for the longest seam of each panel.
#include "seam_reasons.h"

#include "seam_chains.h"

#include <map>

namespace developable::detail {

namespace {

constexpr double hardly = 0.05; ///< of the movement without a seam: that with it

/// \param still  whether the panel hardly moves as it is
Reason reasonOf(const PanelVerdict& verdict, bool still) {
	switch (verdict.obstacle) {
	case Obstacle::NoSheet:
		return Reason::SeamNoSheet;
	case Obstacle::TooFar:
		return Reason::SeamTooFar;
	case Obstacle::Crumples:
		return Reason::SeamCrumples;
	case Obstacle::Overlaps:
		return verdict.disk ? Reason::SeamOverlaps : Reason::SeamNoSheet;
	case Obstacle::BeyondBounds:
		return Reason::SeamBeyondBounds;
	case Obstacle::None:
	case Obstacle::Unpromising: // of tests that are not these
		break;
	}
	if (!verdict.disk)
		return Reason::SeamNoSheet;
	return still ? Reason::SeamStill : Reason::SeamSewn;
}

} // namespace

void explainSeams(CutSurface& surface, PanelTests& tests, SewnPanels& sewn) {
	const std::vector<SeamChain> chains = longestFirst(seamChains(surface));
	std::map<int, std::size_t> longest; // of each panel
	for (std::size_t i = 0; i < chains.size(); ++i)
		for (const int panel : chains[i].panels)
			longest.emplace(panel, i);
	std::vector<PanelTrial> trials;
	std::map<std::size_t, std::size_t> trialOfChain;
	for (const auto& [panel, chain] : longest)
		if (trialOfChain.emplace(chain, trials.size()).second)
			trials.push_back(trialAcross(surface, chains[chain].halfEdges));
	tests.scaleLimits(1);
	const std::vector<PanelVerdict> verdicts = tests.test(trials);
	for (const auto& [panel, chain] : longest) {
		CutPanel& report = sewn.panels[panel];
		const SeamChain& seam = chains[chain];
		if (tests.stopped() || !report.developable)
			continue;
		const PanelVerdict& verdict = verdicts[trialOfChain.at(chain)];
		report.reason = reasonOf(verdict, report.maxDisplacement < hardly * verdict.maxDisplacement);
		report.neighbour = seam.panels[seam.panels[0] == panel ? 1 : 0];
		report.seamPoint = surface.middleOf(seam.halfEdges[seam.halfEdges.size() / 2]);
	}
}

} // namespace developable::detail
