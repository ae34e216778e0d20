// SPDX-License-Identifier: GPL-3.0-or-later
// slit_labels.cpp: which seams between clusters were open, by where they ran.
#include "slit_labels.h"

#include "ring_slits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace developable::detail {

namespace {

/// \param euler  characteristic of the panel that is to be
/// \return       whether some half edges of a panel are open now: they stay a slit where the panel would get
///               a hole that it has not to have
bool openUnlessHole(CutSurface& surface, const std::vector<int>& halfEdges, int euler) {
	const int panel = surface.panelOf(triangleOf(halfEdges.front()));
	const int before = eulerCharacteristic(surface, panel);
	surface.join(halfEdges);
	if (eulerCharacteristic(surface, panel) >= std::min(before, euler))
		return true;
	for (const int h : halfEdges)
		surface.setCut(h, true);
	return false;
}

/// The same with chains, of which some may not open before others have.
/// \param eulerAt  the characteristic that the panel of a triangle is to have
void openUnlessHoles(CutSurface& surface, std::vector<SeamChain> chains,
					 const std::function<int(int)>& eulerAt) {
	const auto opens = [&](const SeamChain& chain) {
		return !surface.isCut(chain.halfEdges.front()) || // it was between two panels
			   openUnlessHole(surface, chain.halfEdges, eulerAt(triangleOf(chain.halfEdges.front())));
	};
	std::size_t before = 0;
	do {
		before = chains.size();
		chains.erase(std::remove_if(chains.begin(), chains.end(), opens), chains.end());
	} while (chains.size() < before);
}

/// The parts of a chain along which something is the same.
template <class Property>
std::vector<SeamChain> runsAlike(const CutSurface& surface, const SeamChain& chain,
								 const Property& propertyAt) {
	std::vector<SeamChain> runs;
	for (const int h : chain.halfEdges) {
		if (runs.empty() || propertyAt(h) != propertyAt(runs.back().halfEdges.front())) {
			runs.emplace_back();
			runs.back().panels = chain.panels;
		}
		runs.back().halfEdges.push_back(h);
		runs.back().length += surface.length(h);
	}
	return runs;
}

} // namespace

SlitLabels::SlitLabels(const CutSurface& surface, const std::vector<int>& clusters) : surface_(surface) {
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		eulerOfPanel_.push_back(
			surface.trianglesOf(panel).empty() ? 1 : std::min(eulerCharacteristic(surface, panel), 1));
	std::vector<char> hasSlit(surface.panelCount(), 0);
	for (const SeamChain& chain : seamChains(surface))
		if (chain.within())
			hasSlit[chain.panels[0]] = 1;
	std::map<std::pair<int, int>, int> numbers;
	for (std::size_t t = 0; t < clusters.size(); ++t) {
		const int panel = surface.panelOf(static_cast<int>(t));
		const auto [found, isNew] =
			numbers.emplace(std::make_pair(panel, hasSlit[panel] ? clusters[t] : -1), count());
		if (isNew)
			panelOfLabel_.push_back(panel);
		labels_.push_back(found->second);
	}
}

/// Where two labels of one panel meet, openly and cut: middles of edges.
struct SlitLabels::Meeting {
	std::vector<Eigen::Vector3d> open, cut;
};

SlitLabels::Meetings SlitLabels::meetings() const {
	Meetings result;
	for (int h = 0; h < 3 * surface_.assembly().triangleCount(); ++h) {
		const int across = surface_.assembly().across(h);
		if (across < 0)
			continue;
		const int a = labels_[triangleOf(h)], b = labels_[triangleOf(across)];
		if (a == b || panelOfLabel_[a] != panelOfLabel_[b])
			continue;
		Meeting& meeting = result[std::minmax(a, b)];
		(surface_.isCut(h) ? meeting.cut : meeting.open).push_back(surface_.middleOf(h));
	}
	return result;
}

void SlitLabels::openWithin(CutSurface& other, const std::vector<int>& labels) const {
	std::vector<SeamChain> open, unknown, cut;
	const Meetings meetings = this->meetings();
	for (const SeamChain& chain : seamChains(other)) {
		const int a = labels[triangleOf(chain.halfEdges.front())];
		const int b = labels[triangleOf(other.assembly().across(chain.halfEdges.front()))];
		if (panelOfLabel_[a] != panelOfLabel_[b])
			continue;
		const auto meeting = meetings.find(std::minmax(a, b));
		const auto evidenceAt = [&](int h) {
			return meeting == meetings.end() ? Evidence::None : evidence(meeting->second, other.middleOf(h));
		};
		for (const SeamChain& run : runsAlike(other, chain, evidenceAt)) {
			const Evidence evidence = evidenceAt(run.halfEdges.front());
			(evidence == Evidence::Open ? open : evidence == Evidence::Cut ? cut : unknown).push_back(run);
		}
	}
	const auto isBetweenTwo = [&](const SeamChain& chain) {
		const int h = chain.halfEdges.front();
		return other.panelOf(triangleOf(h)) != other.panelOf(triangleOf(other.assembly().across(h)));
	};
	for (const std::vector<SeamChain>& chains : {open, unknown, longestFirst(cut)}) // a panel stays one
		for (const SeamChain& chain : chains)
			if (isBetweenTwo(chain))
				other.join(chain.halfEdges);
	const auto eulerAt = [&](int triangle) { return eulerOfPanel_[panelOfLabel_[labels[triangle]]]; };
	openUnlessHoles(other, std::move(open), eulerAt);
	for (int panel = 0; panel < other.panelCount(); ++panel)
		if (!other.trianglesOf(panel).empty())
			slitHoles(other, panel, eulerAt(other.trianglesOf(panel).front()));
}

SlitLabels::Evidence SlitLabels::evidence(const Meeting& meeting, const Eigen::Vector3d& at) {
	const auto distanceTo = [&](const std::vector<Eigen::Vector3d>& middles) {
		double nearest = std::numeric_limits<double>::infinity();
		for (const Eigen::Vector3d& middle : middles)
			nearest = std::min(nearest, (middle - at).norm());
		return nearest;
	};
	return distanceTo(meeting.open) <= distanceTo(meeting.cut) ? Evidence::Open : Evidence::Cut;
}

} // namespace developable::detail
