// SPDX-License-Identifier: GPL-3.0-or-later
// slit_labels.cpp: which seams between clusters were open, by where they ran.
#include "slit_labels.h"

#include <cmath>
#include <limits>
#include <map>

namespace developable::detail {

SlitLabels::SlitLabels(const CutSurface& surface, const std::vector<int>& clusters) : surface_(surface) {
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

void SlitLabels::openWithin(CutSurface& other, const std::vector<int>& labels) const {
	std::vector<SeamChain> open, unknown, cut;
	for (const SeamChain& chain : seamChains(other)) {
		const int a = labels[triangleOf(chain.halfEdges.front())];
		const int b = labels[triangleOf(other.assembly().across(chain.halfEdges.front()))];
		if (panelOfLabel_[a] != panelOfLabel_[b])
			continue;
		const Evidence evidence = wasOpen(other, chain, a, b);
		(evidence == Evidence::Open ? open : evidence == Evidence::Cut ? cut : unknown).push_back(chain);
	}
	for (const SeamChain& chain : open)
		other.join(chain.halfEdges);
	for (const std::vector<SeamChain>& chains : {unknown, longestFirst(cut)})
		for (const SeamChain& chain : chains) // a panel stays one; never so that a ring comes of it
			if (other.panelOf(triangleOf(chain.halfEdges.front())) !=
				other.panelOf(triangleOf(other.assembly().across(chain.halfEdges.front()))))
				other.join(chain.halfEdges);
}

SlitLabels::Evidence SlitLabels::wasOpen(const CutSurface& other, const SeamChain& chain, int a,
										 int b) const {
	const Eigen::Vector3d at = other.middleOf(chain.halfEdges[chain.halfEdges.size() / 2]);
	double toOpen = std::numeric_limits<double>::infinity(), toCut = toOpen;
	for (int h = 0; h < 3 * surface_.assembly().triangleCount(); ++h) {
		const int across = surface_.assembly().across(h);
		if (across < 0 || labels_[triangleOf(h)] != a || labels_[triangleOf(across)] != b)
			continue;
		double& nearest = surface_.isCut(h) ? toCut : toOpen;
		nearest = std::min(nearest, (surface_.middleOf(h) - at).norm());
	}
	if (std::isinf(toOpen) && std::isinf(toCut))
		return Evidence::None;
	return toOpen <= toCut ? Evidence::Open : Evidence::Cut;
}

} // namespace developable::detail
