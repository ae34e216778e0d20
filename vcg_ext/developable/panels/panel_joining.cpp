// SPDX-License-Identifier: GPL-3.0-or-later
// panel_joining.cpp: a greedy order, tests of several disjoint pairs at once, and what is known to fail.
#include "panel_joining.h"

#include <algorithm>
#include <limits>

namespace developable::detail {

namespace {

/// Pairs that are tested at once. Pairs in a batch have no panel in common, so that the outcome of one does
/// not change another; the number is fixed, so that the outcome does not depend on the machine.
constexpr int batchSize = 4;
constexpr std::size_t aheadAtOnce = 2; ///< tests on a thread that would idle

constexpr double smallShare = 0.05; ///< of a patch's area
constexpr int mostFailures = 6;     ///< of joins that were sewn together

class Joining {
public:
	Joining(CutSurface& surface, PanelTests& tests, JoinHistory& history,
			const std::function<bool(const SeamChain&)>& mayGo)
		: surface_(surface), tests_(tests), history_(history), mayGo_(mayGo) {}

	void run() {
		const double first = static_cast<double>(seamChains(surface_).size());
		while (true) {
			const std::vector<SeamChain> batch = nextBatch();
			const std::string message =
				std::to_string(left_.size()) + " seams between panels to try to take out";
			if (batch.empty() ||
				!tests_.mayGoOn(0.2 + 0.5 * (1 - double(left_.size()) / std::max(first, 1.0)), message))
				return;
			joinThoseThatMay(batch);
		}
	}

private:
	/// What keeps a panel from being a ring has to stay; a dart may go.
	static bool isSlit(const SeamChain& chain) { return chain.within() && !chain.isDart(); }

	std::vector<SeamChain> nextBatch() {
		std::vector<SeamChain> chains = seamChains(surface_);
		chains.erase(std::remove_if(chains.begin(), chains.end(),
									[&](const SeamChain& chain) {
										return isSlit(chain) || (mayGo_ && !mayGo_(chain)) ||
											   history_.wasRefused(surface_, chain.halfEdges);
									}),
					 chains.end());
		left_ = longestFirst(std::move(chains));
		return firstApart(left_, batchSize);
	}

	PanelTrial trialAt(const SeamChain& chain) {
		PanelTrial trial = trialAcross(surface_, chain.halfEdges);
		trial.onlyIfPromising = true;
		return trial;
	}

	/// Most unions are no panels: then the next longest seams are tried.
	void testAhead(const std::vector<SeamChain>& batch, const std::vector<PanelTrial>& trials) {
		const auto isInBatch = [&](const SeamChain& chain) {
			return std::any_of(batch.begin(), batch.end(), [&](const SeamChain& other) {
				return other.halfEdges.front() == chain.halfEdges.front();
			});
		};
		int idle = tests_.idleBeside(trials);
		for (auto chain = left_.begin(); idle > 0; --idle) {
			std::vector<PanelTrial> next;
			for (; chain != left_.end() && next.size() < aheadAtOnce; ++chain) {
				if (isInBatch(*chain))
					continue;
				PanelTrial trial = trialAt(*chain);
				if (!tests_.knowsSoon(trial))
					next.push_back(std::move(trial));
			}
			if (next.empty())
				return;
			ahead_.begin([next = std::move(next)](PanelTester& tests) { tests.test(next); });
		}
	}

	void joinThoseThatMay(const std::vector<SeamChain>& batch) {
		std::vector<PanelTrial> trials;
		trials.reserve(batch.size());
		for (const SeamChain& chain : batch)
			trials.push_back(trialAt(chain));
		testAhead(batch, trials);
		const std::vector<PanelVerdict> verdicts = tests_.test(trials);
		for (std::size_t i = 0; i < batch.size() && !tests_.stopped(); ++i)
			if (verdicts[i].isPanel())
				history_.join(surface_, batch[i].halfEdges);
			else
				history_.refuse(surface_, batch[i].halfEdges);
		if (std::any_of(verdicts.begin(), verdicts.end(),
						[](const auto& verdict) { return verdict.isPanel(); }))
			ahead_.abandon();
	}

	CutSurface& surface_;
	PanelTests& tests_;
	JoinHistory& history_;
	const std::function<bool(const SeamChain&)>& mayGo_;
	std::vector<SeamChain> left_; // the longest first
	TestsAhead ahead_{tests_};
};

} // namespace

void joinPanels(CutSurface& surface, PanelTests& tests, JoinHistory& history,
				const std::function<bool(const SeamChain&)>& mayGo) {
	Joining(surface, tests, history, mayGo).run();
}

bool SewnJoining::join(const std::vector<int>& halfEdges) {
	const int patch = surface_.assembly().patchOfTriangle[triangleOf(halfEdges.front())];
	const auto areaAt = [&](int h) { return surface_.area(surface_.panelOf(triangleOf(h))); };
	const int across = surface_.assembly().across(halfEdges.front());
	if (areaAt(halfEdges.front()) + areaAt(across) < smallShare * surface_.patchArea(patch)) {
		surface_.join(halfEdges);
		return true;
	}
	if (failures_ >= mostFailures)
		return false;
	if (before_ < 0)
		before_ = excess_();
	CutSurface saved = surface_; // with the numbers of its panels, by which failures are known
	surface_.join(halfEdges);
	const double after = excess_();
	if (after <= before_) {
		before_ = after;
		return true;
	}
	surface_ = std::move(saved);
	++failures_;
	return false;
}

} // namespace developable::detail
