// SPDX-License-Identifier: GPL-3.0-or-later
// panel_dissolving.cpp: one panel after the other.
#include "panel_dissolving.h"

#include "panel_joining.h"

#include <algorithm>
#include <set>

namespace developable::detail {

namespace {

constexpr double workBesideJoining = 1.5; ///< of the work that was done before
constexpr double shorter = 0.98;          ///< share of the seams' length that is worth while

class Dissolving {
public:
	Dissolving(CutSurface& surface, const std::vector<int>& clusters, PanelTests& tests, JoinHistory& history)
		: surface_(surface), clusters_(clusters), tests_(tests), history_(history),
		  mostWork_(tests.workWith(workBesideJoining)) {}

	void run() {
		while (!tests_.stopped() && dissolveOne())
			continue;
	}

private:
	/// \return whether there was any that made a difference
	bool dissolveOne() {
		std::vector<int> panels;
		for (int panel = 0; panel < surface_.panelCount(); ++panel)
			if (!surface_.trianglesOf(panel).empty())
				panels.push_back(panel);
		std::stable_sort(panels.begin(), panels.end(),
						 [&](int a, int b) { return surface_.area(a) < surface_.area(b); });
		for (const int panel : panels) {
			if (tests_.stopped() || !mayGoOn())
				return false;
			if (known_.insert(surface_.trianglesOf(panel)).second && dissolve(panel))
				return true;
		}
		return false;
	}

	bool mayGoOn() const { return tests_.work() < mostWork_; }

	bool dissolve(int panel) {
		if (clustersOf(panel).size() < 2)
			return false;
		CutSurface before = surface_; // with the numbers of its panels
		const std::set<int> pieces = fallApart(panel);
		joinPanels(surface_, tests_, history_, [&](const SeamChain& chain) {
			return mayGoOn() && pieces.count(chain.panels[0]) != pieces.count(chain.panels[1]);
		});
		joinPanels(surface_, tests_, history_, [&](const SeamChain&) { return mayGoOn(); });
		const int count = surface_.usedPanelCount(), countBefore = before.usedPanelCount();
		if (count < countBefore ||
			(count == countBefore && seamLength(surface_) < shorter * seamLength(before)))
			return true;
		surface_ = std::move(before);
		return false;
	}

	std::set<int> clustersOf(int panel) const {
		std::set<int> found;
		for (const int t : surface_.trianglesOf(panel))
			found.insert(clusters_[t]);
		return found;
	}

	/// \return the panels that a panel becomes
	std::set<int> fallApart(int panel) {
		const std::vector<int> triangles = surface_.trianglesOf(panel);
		std::vector<int> labels;
		labels.reserve(triangles.size());
		for (const int t : triangles)
			labels.push_back(clusters_[t]);
		surface_.divide(panel, labels);
		std::set<int> pieces;
		for (const int t : triangles)
			pieces.insert(surface_.panelOf(t));
		return pieces;
	}

	CutSurface& surface_;
	const std::vector<int>& clusters_;
	PanelTests& tests_;
	JoinHistory& history_;
	const double mostWork_;
	std::set<std::vector<int>> known_; // the triangles of panels that were tried
};

} // namespace

void dissolvePanels(CutSurface& surface, const std::vector<int>& clusters, PanelTests& tests,
					JoinHistory& history) {
	Dissolving(surface, clusters, tests, history).run();
}

} // namespace developable::detail
