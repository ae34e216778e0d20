// SPDX-License-Identifier: GPL-3.0-or-later
// overlap_closing.cpp: cuts are closed, triangles change sides.
#include "overlap_closing.h"

#include "seam_chains.h"
#include "sewn_failures.h"
#include "small_panels.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

/// Of the darts that have some of a notch's edges the one that is shortest from its tip to the farthest of
/// them, as half edges from there; or none.
std::vector<int> dartToClose(const CutSurface& surface, const std::vector<int>& notch) {
	const auto isWanted = [&](int h) {
		return std::any_of(notch.begin(), notch.end(),
						   [&](int other) { return other == h || other == surface.assembly().across(h); });
	};
	std::vector<int> best;
	double least = std::numeric_limits<double>::infinity();
	for (const SeamChain& chain : seamChains(surface)) {
		std::vector<int> fromTip = chain.halfEdges;
		if (!chain.isDart())
			continue;
		if (!chain.freeEnd[0])
			std::reverse(fromTip.begin(), fromTip.end());
		while (!fromTip.empty() && !isWanted(fromTip.back()))
			fromTip.pop_back();
		double length = 0;
		for (const int h : fromTip)
			length += surface.length(h);
		if (!fromTip.empty() && length < least) {
			least = length;
			best = std::move(fromTip);
		}
	}
	return best;
}

/// \return whether the slits beside some triangles of their own panel can run at their other sides
bool moveSlits(CutSurface& surface, int panel, const std::set<int>& triangles) {
	for (const int t : triangles)
		for (int h = 3 * t; h < 3 * t + 3; ++h) {
			const int across = surface.assembly().across(h);
			if (across < 0 || surface.panelOf(triangleOf(across)) != panel)
				return false;
			surface.setCut(h, !surface.isCut(h));
		}
	return true;
}

/// \param triangle  of the panel that takes some
/// \param taken     triangles of one neighbour
/// \return          whether that leaves two panels
bool takeFromNeighbour(CutSurface& surface, int triangle, const std::set<int>& taken) {
	const int panel = surface.panelOf(triangle);
	std::set<int> own(surface.trianglesOf(panel).begin(), surface.trianglesOf(panel).end());
	own.insert(taken.begin(), taken.end());
	const std::vector<int> seam = halfEdgesBetween(surface, panel, surface.panelOf(*taken.begin()));
	return divideAnew(surface, seam, own).size() == 2;
}

/// The triangles at the other side of some half edges change to this one.
bool fillNotch(CutSurface& surface, int panel, const std::vector<int>& notch, const std::vector<char>& held) {
	std::set<int> slits;
	std::map<int, std::set<int>> ofNeighbours; // by panel
	for (const int h : notch) {
		const int across = surface.assembly().across(h);
		if (across < 0 || (!held.empty() && held[triangleOf(across)]))
			return false;
		const int other = surface.panelOf(triangleOf(across));
		(other == panel ? slits : ofNeighbours[other]).insert(triangleOf(across));
	}
	const int triangle = surface.trianglesOf(panel).front();
	if (!moveSlits(surface, panel, slits))
		return false;
	return std::all_of(ofNeighbours.begin(), ofNeighbours.end(), [&](const auto& neighbour) {
		return takeFromNeighbour(surface, triangle, neighbour.second);
	});
}

/// Whether panels are disks, or what they were.
bool isAsWhole(const CutSurface& after, const CutSurface& before) {
	for (int panel = 0; panel < after.panelCount(); ++panel) {
		if (after.trianglesOf(panel).empty())
			continue;
		const int own = before.panelOf(after.trianglesOf(panel).front());
		const int now = eulerCharacteristic(after, panel);
		if (now != 1 && now != eulerCharacteristic(before, own))
			return false;
	}
	return after.usedPanelCount() == before.usedPanelCount();
}

/// Unless panels fail for other reasons. Where one notch goes others may, too.
bool closeNotches(CutSurface& surface, const std::vector<char>& held, const SewnPanels& sewn) {
	if (sewn.notches.size() < worstFirst(sewn).size())
		return false;
	CutSurface closed = surface;
	const auto isStillThere = [&](int h) { return closed.across(h) < 0; };
	for (const auto& [panel, notches] : sewn.notches)
		for (const std::vector<int>& notch : notches)
			// the panel's number may have changed where its neighbour was closed
			if (std::all_of(notch.begin(), notch.end(), isStillThere) &&
				!closeNotch(closed, closed.panelOf(triangleOf(notch.front())), notch, held))
				return false;
	surface = std::move(closed);
	return true;
}

/// What overlaps, and what then still does on the same shape. \return whether anything was closed
bool closeWhatIsSeen(CutSurface& surface, const std::vector<char>& held, const SewnPanels& sewn,
					 const ClosingSteps& steps) {
	constexpr int looks = 6;
	bool any = closeNotches(surface, held, sewn);
	for (int look = 0; any && look < looks && steps.mayGoOn(); ++look) {
		const SewnPanels seen = steps.look(sewn);
		if (worstOf(seen) < 0 || !closeNotches(surface, held, seen))
			break;
	}
	return any;
}

} // namespace

bool closeNotch(CutSurface& surface, int panel, const std::vector<int>& notch,
				const std::vector<char>& held) {
	CutSurface closed = surface;
	const std::vector<int> dart = dartToClose(surface, notch);
	for (const int h : dart)
		closed.setCut(h, false);
	if (!dart.empty() && isAsWhole(closed, surface)) {
		surface = std::move(closed);
		return true;
	}
	const std::vector<int> inner(notch.begin() + 1, notch.end() - 1);
	for (const std::vector<int>& part : {notch, inner}) {
		closed = surface;
		if (!part.empty() && fillNotch(closed, panel, part, held) && isAsWhole(closed, surface)) {
			surface = std::move(closed);
			return true;
		}
	}
	return false;
}

SewnPanels closeOverlaps(CutSurface& surface, const std::vector<char>& held, SewnPanels sewn,
						 const ClosingSteps& steps) {
	constexpr int rounds = 6;
	for (int round = 0; round < rounds && worstOf(sewn) >= 0 && steps.mayGoOn(); ++round) {
		if (!closeWhatIsSeen(surface, held, sewn, steps))
			break;
		sewn = steps.sew();
	}
	return sewn;
}

} // namespace developable::detail
