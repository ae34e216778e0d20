// SPDX-License-Identifier: GPL-3.0-or-later
// relieved_joining.cpp: unions that need a dart or two.
#include "panel_joining.h"
#include "relief_darts.h"

#include <algorithm>
#include <set>

namespace developable::detail {

namespace {

constexpr int unionsAtOnce = 4;         ///< of unions in whose darts are tried together
constexpr int mostDarts = 6;            ///< in a union
constexpr double worthwhile = 0.7;      ///< of the seam that goes: darts of more length are no gain
constexpr double lengthIncrease = 1.25; ///< from a dart to the next
constexpr double workOnUnions = 0.5;    ///< of the work that was done before

/// Two panels as one, with darts.
struct Union {
	SeamChain chain;
	CutSurface surface;
	int panel = -1;
	std::vector<Eigen::Vector3d> tips;
	double dartLength = 0;
	PanelVerdict verdict;

	bool holds() const { return verdict.isPanel(); }
};

class RelievedJoining {
public:
	RelievedJoining(CutSurface& surface, PanelTests& tests, JoinHistory& history,
					std::vector<Eigen::Vector3d>& tips, const std::vector<char>& held)
		: surface_(surface), tests_(tests), history_(history), tips_(tips), held_(held),
		  mostWork_(tests.workWith(workOnUnions)) {}

	void run() {
		while (!tests_.stopped() && tests_.work() < mostWork_) {
			std::vector<Union> unions = nextUnions();
			if (unions.empty() || !tests_.mayGoOn(0.7, "trying panels with darts"))
				return;
			relieveAhead(unions);
			relieve(unions, tests_);
			for (const Union& joined : unions)
				if (joined.holds() && !tests_.stopped())
					keep(joined);
		}
	}

private:
	using Key = std::array<int, 3>;

	static Key keyOf(const SeamChain& chain) {
		return {chain.panels[0], chain.panels[1], chain.halfEdges.front()};
	}

	Union unionAcross(const SeamChain& chain) const {
		Union joined{chain, surface_, -1, {}, 0, {}};
		joined.panel = joined.surface.join(chain.halfEdges);
		return joined;
	}

	/// Across the longest seams that were not tried; no two have a panel in common.
	std::vector<Union> nextUnions() {
		const auto isNew = [&](const SeamChain& chain) {
			return !chain.within() && tried_.insert(keyOf(chain)).second;
		};
		std::vector<Union> unions;
		for (const SeamChain& chain : firstApart(longestFirst(seamChains(surface_)), unionsAtOnce, isNew))
			unions.push_back(unionAcross(chain));
		return unions;
	}

	/// Each at its own pace. Most unions do not hold: then the next are tried.
	void relieveAhead(const std::vector<Union>& unions) {
		for (std::size_t i = 1; i < unions.size(); ++i)
			relieveAhead(unions[i].chain);
		for (const SeamChain& chain : longestFirst(seamChains(surface_)))
			if (!chain.within() && tried_.count(keyOf(chain)) == 0)
				relieveAhead(chain);
	}

	void relieveAhead(const SeamChain& chain) {
		if (tests_.idleBeside({}) > 1 && begun_.insert(keyOf(chain)).second) // one is for this thread
			ahead_.begin([this, unions = std::vector<Union>{unionAcross(chain)}](PanelTester& tests) mutable {
				relieve(unions, tests);
			});
	}

	/// Another dart in each that does not hold, again and again.
	void relieve(std::vector<Union>& unions, PanelTester& tests) const {
		std::vector<Union*> open;
		open.reserve(unions.size());
		for (Union& joined : unions)
			open.push_back(&joined);
		double length = firstDartLength;
		for (int darts = 0; !open.empty() && !tests.stopped(); ++darts, length *= lengthIncrease) {
			test(open, tests);
			open.erase(std::remove_if(open.begin(), open.end(),
									  [&](Union* joined) {
										  return joined->holds() || !joined->verdict.disk ||
												 darts == mostDarts || !addDart(*joined, length);
									  }),
					   open.end());
		}
	}

	static void test(const std::vector<Union*>& unions, PanelTester& tests) {
		std::vector<PanelTrial> trials;
		trials.reserve(unions.size());
		for (const Union* joined : unions)
			trials.push_back(trialOf(joined->surface, joined->surface.trianglesOf(joined->panel)));
		const std::vector<PanelVerdict> verdicts = tests.test(trials);
		for (std::size_t i = 0; i < unions.size(); ++i)
			unions[i]->verdict = verdicts[i];
	}

	/// \return whether there was room for it, and it pays
	bool addDart(Union& joined, double length) const {
		const Dart dart = cutDart(joined.surface, joined.panel, joined.verdict.worstPoint, length, held_);
		joined.tips.push_back(dart.tip);
		joined.dartLength += dart.length;
		return dart.length > 0 && joined.dartLength < worthwhile * joined.chain.length;
	}

	void keep(const Union& joined) {
		ahead_.abandon();
		begun_.clear();
		history_.join(surface_, joined.chain.halfEdges);
		const int panel = surface_.panelOf(triangleOf(joined.chain.halfEdges.front()));
		for (const int t : surface_.trianglesOf(panel))
			for (int h = 3 * t; h < 3 * t + 3; ++h)
				if (joined.surface.isCut(h) != surface_.isCut(h))
					surface_.setCut(h, joined.surface.isCut(h));
		tips_.insert(tips_.end(), joined.tips.begin(), joined.tips.end());
	}

	CutSurface& surface_;
	PanelTests& tests_;
	JoinHistory& history_;
	std::vector<Eigen::Vector3d>& tips_;
	const std::vector<char>& held_;
	const double mostWork_;
	std::set<Key> tried_;
	std::set<Key> begun_; // ahead
	TestsAhead ahead_{tests_};
};

} // namespace

void joinWithRelief(CutSurface& surface, PanelTests& tests, JoinHistory& history,
					std::vector<Eigen::Vector3d>& tips, const std::vector<char>& held) {
	RelievedJoining(surface, tests, history, tips, held).run();
}

} // namespace developable::detail
