// SPDX-License-Identifier: GPL-3.0-or-later
// seam_chains.cpp: walks along cuts from junctions and ends.
#include "seam_chains.h"

#include <algorithm>
#include <set>

namespace developable::detail {

namespace {

class ChainWalker {
public:
	explicit ChainWalker(const CutSurface& surface)
		: surface_(surface), walked_(3 * surface.assembly().triangleCount(), 0) {
		const PatchAssembly& assembly = surface.assembly();
		for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
			if (surface.isCut(h) && h < assembly.across(h))
				cuts_.push_back(h);
		std::vector<int> ends;
		for (const int h : cuts_) {
			ends.push_back(surface.startOf(h));
			ends.push_back(surface.endOf(h));
		}
		atCopy_ =
			grouped(assembly.copyCount(), static_cast<int>(ends.size()), [&](int i) { return ends[i]; });
	}

	std::vector<SeamChain> chains() {
		std::vector<SeamChain> result;
		for (const bool closed : {false, true}) // closed curves are what has no end
			for (const int h : cuts_)
				for (const int copy : {surface_.startOf(h), surface_.endOf(h)})
					if (!walked_[h] && (closed || isEnd(copy)))
						result.push_back(walk(h, copy));
		std::sort(result.begin(), result.end(), [](const SeamChain& a, const SeamChain& b) {
			return *std::min_element(a.halfEdges.begin(), a.halfEdges.end()) <
				   *std::min_element(b.halfEdges.begin(), b.halfEdges.end());
		});
		return result;
	}

private:
	bool onBorder(int copy) const { return !surface_.assembly().copyInterior[copy]; }
	bool isEnd(int copy) const {
		return atCopy_.size(copy) != 2 || onBorder(copy) || surface_.isSharpPoint(copy);
	}
	bool isFree(int copy) const { return atCopy_.size(copy) == 1 && !onBorder(copy); }

	SeamChain walk(int halfEdge, int from) {
		SeamChain chain;
		chain.panels = {surface_.panelOf(triangleOf(halfEdge)),
						surface_.panelOf(triangleOf(surface_.assembly().across(halfEdge)))};
		chain.ends[0] = from;
		int copy = from, next = halfEdge;
		while (next >= 0) {
			walked_[next] = 1;
			chain.halfEdges.push_back(next);
			chain.length += surface_.length(next);
			copy = surface_.startOf(next) == copy ? surface_.endOf(next) : surface_.startOf(next);
			next = isEnd(copy) ? -1 : unwalkedAt(copy);
		}
		chain.ends[1] = copy;
		chain.freeEnd = {isFree(chain.ends[0]), isFree(chain.ends[1])};
		return chain;
	}

	int unwalkedAt(int copy) const {
		for (const int* i = atCopy_.begin(copy); i != atCopy_.end(copy); ++i)
			if (!walked_[cuts_[*i / 2]])
				return cuts_[*i / 2];
		return -1;
	}

	const CutSurface& surface_;
	std::vector<char> walked_; // per half edge, of the first of each edge
	std::vector<int> cuts_;    // the first half edge of each edge that is cut
	Groups atCopy_;            // ends of cuts by their copy
};

} // namespace

std::vector<SeamChain> seamChains(const CutSurface& surface) {
	return ChainWalker(surface).chains();
}

std::vector<SeamChain> longestFirst(std::vector<SeamChain> chains) {
	std::stable_sort(chains.begin(), chains.end(),
					 [](const SeamChain& a, const SeamChain& b) { return a.length > b.length; });
	return chains;
}

std::vector<SeamChain> firstApart(const std::vector<SeamChain>& chains, int most,
								  const std::function<bool(const SeamChain&)>& mayTake) {
	std::vector<SeamChain> first;
	std::set<int> taken;
	for (const SeamChain& chain : chains) {
		if (static_cast<int>(first.size()) == most)
			break;
		if (taken.count(chain.panels[0]) + taken.count(chain.panels[1]) > 0 || (mayTake && !mayTake(chain)))
			continue;
		taken.insert(chain.panels.begin(), chain.panels.end());
		first.push_back(chain);
	}
	return first;
}

double seamLength(const CutSurface& surface) {
	double sum = 0;
	for (const SeamChain& chain : seamChains(surface))
		sum += chain.length;
	return sum;
}

} // namespace developable::detail
