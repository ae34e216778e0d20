// SPDX-License-Identifier: GPL-3.0-or-later
// symmetric_joining.cpp: a seam and the seam at its mirror image.
#include "symmetric_joining.h"

#include "seam_chains.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace developable::detail {

namespace {

class SymmetricJoining {
public:
	SymmetricJoining(CutSurface& surface, PanelTests& tests, JoinHistory& history, const MirrorPlane& plane,
					 const std::vector<int>& mirrored)
		: surface_(surface), tests_(tests), history_(history), plane_(plane), mirrored_(mirrored) {}

	void run() {
		while (!tests_.stopped() && joinOne())
			continue;
	}

private:
	using Key = std::array<int, 3>;

	static Key keyOf(const SeamChain& chain) {
		const auto [less, more] = std::minmax(chain.panels[0], chain.panels[1]);
		return {less, more, *std::min_element(chain.halfEdges.begin(), chain.halfEdges.end())};
	}

	/// \return whether any seam could go
	bool joinOne() {
		const std::vector<SeamChain> chains = longestFirst(seamChains(surface_));
		for (const SeamChain& chain : chains) {
			if ((chain.within() && !chain.isDart()) || !tried_.insert(keyOf(chain)).second)
				continue;
			if (!tests_.mayGoOn(0.4, std::to_string(chains.size()) + " seams to try to take out in pairs"))
				return false;
			const SeamChain* image = imageOf(chain, chains);
			if (image == nullptr)
				continue;
			tried_.insert(keyOf(*image));
			if (!history_.wasRefused(surface_, chain.halfEdges) &&
				!history_.wasRefused(surface_, image->halfEdges) && joinBoth(chain, *image))
				return true;
		}
		return false;
	}

	/// The chain between the panels at the mirror image that is nearest to it; null: there is none.
	const SeamChain* imageOf(const SeamChain& chain, const std::vector<SeamChain>& chains) const {
		std::map<std::array<int, 2>, double> votes;
		for (const int h : chain.halfEdges) {
			std::array<int, 2> panels = {
				surface_.panelOf(mirrored_[triangleOf(h)]),
				surface_.panelOf(mirrored_[triangleOf(surface_.assembly().across(h))])};
			std::sort(panels.begin(), panels.end());
			if (panels[0] != panels[1] || chain.within())
				votes[panels] += surface_.length(h);
		}
		const auto most = std::max_element(votes.begin(), votes.end(),
										   [](const auto& a, const auto& b) { return a.second < b.second; });
		if (most == votes.end())
			return nullptr;
		const Eigen::Vector3d image = plane_.mirrored(middleOf(chain));
		const SeamChain* nearest = nullptr;
		double least = std::numeric_limits<double>::infinity();
		for (const SeamChain& other : chains) {
			std::array<int, 2> panels = other.panels;
			std::sort(panels.begin(), panels.end());
			const double distance = (middleOf(other) - image).norm();
			if (panels == most->first && distance < least) {
				least = distance;
				nearest = &other;
			}
		}
		return nearest;
	}

	Eigen::Vector3d middleOf(const SeamChain& chain) const {
		Eigen::Vector3d sum = Eigen::Vector3d::Zero();
		for (const int h : chain.halfEdges)
			sum += surface_.length(h) * surface_.middleOf(h);
		return sum / chain.length;
	}

	/// \return whether both unions, which may be one, are panels
	bool joinBoth(const SeamChain& chain, const SeamChain& image) {
		CutSurface joined = surface_;
		history_.join(joined, chain.halfEdges);
		if (&image != &chain)
			history_.join(joined, image.halfEdges);
		std::vector<PanelTrial> trials;
		const int panel = joined.panelOf(triangleOf(chain.halfEdges.front()));
		const int other = joined.panelOf(triangleOf(image.halfEdges.front()));
		trials.push_back(trialOf(joined, joined.trianglesOf(panel)));
		if (other != panel)
			trials.push_back(trialOf(joined, joined.trianglesOf(other)));
		if (!tests_.areAllPanels(trials))
			return false;
		surface_ = std::move(joined);
		return true;
	}

	CutSurface& surface_;
	PanelTests& tests_;
	JoinHistory& history_;
	const MirrorPlane& plane_;
	const std::vector<int>& mirrored_;
	std::set<Key> tried_; // panels get new numbers when they are joined
};

/// The panel that has most of the mirror image of another, which may be itself.
int imageOf(const CutSurface& surface, int panel, const std::vector<int>& mirrored) {
	std::map<int, double> areas;
	for (const int t : surface.trianglesOf(panel))
		areas[surface.panelOf(mirrored[t])] += surface.areas()[t];
	return std::max_element(areas.begin(), areas.end(),
							[](const auto& a, const auto& b) { return a.second < b.second; })
		->first;
}

/// Of the panels of some triangles the smallest and the largest.
std::pair<int, int> smallestAndLargest(const CutSurface& surface, const std::vector<int>& triangles) {
	const auto [smallest, largest] =
		std::minmax_element(triangles.begin(), triangles.end(), [&](int a, int b) {
			return surface.area(surface.panelOf(a)) < surface.area(surface.panelOf(b));
		});
	return {surface.panelOf(*smallest), surface.panelOf(*largest)};
}

} // namespace

std::vector<int> symmetricLabels(const CutSurface& surface, const MirrorPlane& plane,
								 const std::vector<int>& mirrored) {
	const auto isHere = [&](int t) { return plane.heightOf(surface.barycentre(t)) >= 0; };
	std::vector<int> labels;
	labels.reserve(mirrored.size());
	for (int t = 0; t < static_cast<int>(mirrored.size()); ++t)
		labels.push_back(isHere(t) ? surface.panelOf(t)
								   : surface.panelCount() + surface.panelOf(mirrored[t]));
	return labels;
}

void joinSymmetrically(CutSurface& surface, PanelTests& tests, JoinHistory& history, const MirrorPlane& plane,
					   const std::vector<int>& mirrored) {
	SymmetricJoining(surface, tests, history, plane, mirrored).run();
}

bool takeBackSymmetrically(CutSurface& surface, const std::vector<int>& panels, JoinHistory& history,
						   const std::vector<int>& mirrored) {
	std::set<int> all;
	for (const int panel : panels) {
		all.insert(panel);
		all.insert(imageOf(surface, panel, mirrored));
	}
	bool any = false;
	for (const int panel : all) {
		const std::vector<int> triangles = surface.trianglesOf(panel);
		if (!history.takeBack(surface, panel))
			continue;
		any = true;
		const auto [smaller, larger] = smallestAndLargest(surface, triangles);
		if (smaller != larger && imageOf(surface, smaller, mirrored) == larger)
			history.takeBack(surface, larger); // it lost what was joined on one side: now on the other, too
	}
	return any;
}

} // namespace developable::detail
