// SPDX-License-Identifier: GPL-3.0-or-later
// dart_joining.cpp: seams that go in part.
#include "panel_joining.h"

#include <algorithm>
#include <memory>
#include <set>

namespace developable::detail {

namespace {

/// Of its length, how much of a seam is tried to stay as a dart.
constexpr double shares[] = {0.7, 0.5, 0.35, 0.2, 0.1};

constexpr double workBesideOthers = 0.3; ///< of the work that was done before

/// A part of a seam that might go.
struct Part {
	SeamChain chain;
	std::vector<int> halfEdges; ///< that go
	double length = 0;
	bool fromEnd = false; ///< of the seam's two
};

class DartJoining {
public:
	DartJoining(CutSurface& surface, PanelTests& tests, const SewnExcess& excess)
		: surface_(surface), tests_(tests), sewn_(surface, excess),
		  mostWork_(tests.workWith(workBesideOthers)) {}

	void run() {
		while (tests_.work() < mostWork_ && joinOne())
			continue;
	}

private:
	/// The seams in order of their lengths: the longest part of the first that has one that may go.
	bool joinOne() {
		std::vector<Part> parts; // as little as pays, from either end
		for (const SeamChain& chain : longestFirst(seamChains(surface_)))
			for (const bool fromEnd : {false, true})
				if (mayGoFrom(chain, fromEnd))
					parts.push_back(partOf(chain, fromEnd, shares[0]));
		parts.erase(std::remove_if(parts.begin(), parts.end(),
								   [&](const Part& part) { return failures_.count(keyOf(part)) > 0; }),
					parts.end());
		constexpr std::size_t batch = 4;
		for (std::size_t first = 0; first < parts.size(); first += batch) {
			const std::vector<Part> some(parts.begin() + first,
										 parts.begin() + std::min(parts.size(), first + batch));
			if (tests_.work() > mostWork_)
				return false;
			if (!tests_.mayGoOn(0.8,
								std::to_string(parts.size() - first) + " seams to try to shorten to darts"))
				return false;
			const std::vector<char> mayGo = test(some);
			for (std::size_t i = 0; i < some.size() && !tests_.stopped(); ++i)
				if (mayGo[i] && joinLongest(some[i]))
					return true;
				else
					failures_.insert(keyOf(some[i]));
		}
		return false;
	}

	/// The rest has to begin at a border or another seam.
	static bool mayGoFrom(const SeamChain& chain, bool fromEnd) {
		const bool restIsFree = chain.freeEnd[fromEnd ? 0 : 1], beginsFree = chain.freeEnd[fromEnd ? 1 : 0];
		return !restIsFree && (!chain.within() || beginsFree);
	}

	Part partOf(const SeamChain& chain, bool fromEnd, double share) const {
		Part part{chain, {}, 0, fromEnd};
		std::vector<int> halfEdges = chain.halfEdges;
		if (fromEnd)
			std::reverse(halfEdges.begin(), halfEdges.end());
		for (const int h : halfEdges) {
			if (!part.halfEdges.empty() && part.length + surface_.length(h) / 2 > (1 - share) * chain.length)
				break;
			part.halfEdges.push_back(h);
			part.length += surface_.length(h);
		}
		return part;
	}

	/// As much of the seam as may go, if any may.
	bool joinLongest(const Part& least) {
		std::vector<Part> more;
		for (const double share : shares)
			more.push_back(partOf(least.chain, least.fromEnd, share));
		const std::vector<char> mayGo = test(more);
		for (std::size_t i = more.size(); i-- > 0;)
			if (mayGo[i] && sewn_.join(more[i].halfEdges))
				return true;
		return false;
	}

	std::vector<char> test(const std::vector<Part>& parts) {
		std::vector<PanelTrial> trials;
		trials.reserve(parts.size());
		for (const Part& part : parts)
			trials.push_back(trialAcross(surface_, part.halfEdges));
		std::vector<char> mayGo;
		for (const PanelVerdict& verdict : tests_.test(trials))
			mayGo.push_back(verdict.isPanel());
		return mayGo;
	}

	static std::array<int, 4> keyOf(const Part& part) {
		return {part.chain.panels[0], part.chain.panels[1], part.halfEdges.front(), part.halfEdges.back()};
	}

	CutSurface& surface_;
	PanelTests& tests_;
	SewnJoining sewn_;
	const double mostWork_;
	std::set<std::array<int, 4>> failures_;
};

} // namespace

void joinWithDarts(CutSurface& surface, PanelTests& tests, const SewnExcess& excess) {
	DartJoining(surface, tests, excess).run();
}

} // namespace developable::detail
