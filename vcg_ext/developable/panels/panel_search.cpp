// SPDX-License-Identifier: GPL-3.0-or-later
// panel_search.cpp: searches that begin with clusters of several sizes, the most promising first.
#include "panel_search.h"

#include "sewn_failures.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

constexpr double littleWork = 6e6; ///< see WorkBudget: some seconds
constexpr double muchWork = 5e7;   ///< see WorkBudget: a minute or two
constexpr int mostSearches = 2;    ///< of those that take longer
constexpr double littleCurvature =
	3 * 4 * pi; ///< inside panels, rad: as much as three closed convex shapes have
constexpr double muchCurvature = 16 * 4 * pi; ///< of all that is to be cut: it has limbs, or detail
constexpr double shareOfFirst = 0.1, shareOfJoining = 0.7; ///< of the time of a search

/// The better of two first, the other behind it.
void addSearch(FoundPanels& found, FoundPanels next) {
	if (isBetter(next, found))
		std::swap(found, next);
	if (next.hold)
		found.planned.insert(found.planned.end(), next.planned.begin(), next.planned.end());
}

/// A search, and where it begins.
class Start {
public:
	Start(const SearchInput& input, const Progress& progress)
		: progress_(progress), plan_(input, [this](double done, const std::string& what) {
			  return mayGoOn(progress_, done, what);
		  }) {}
	Start(const Start&) = delete;
	Start& operator=(const Start&) = delete;

	PanelPlan& plan() { return plan_; }
	/// Also before it was joined.
	bool stopped() const { return !joined_ || plan_.stopped(); }
	const CutSurface& surface() const { return plan_.planned().surface; }

	/// The finer clusters are, the more there is to do. What was joined greedily is not again.
	Task joining() {
		return {double(surface().usedPanelCount()), [this](const Progress& ofTask) {
					withProgress(ofTask, [this] { plan_.join(); });
					joined_ = true;
				}};
	}

	/// Joins greedily, and sees what that comes to.
	void joinGreedily(const Progress& progress) {
		SewnPanels sewn;
		withProgress(progress, [&] {
			plan_.joinGreedily();
			if (!plan_.stopped())
				sewn = plan_.sewnAtFirst();
		});
		double curvature = 0;
		for (const CutPanel& panel : sewn.panels)
			curvature += panel.curvatureBefore;
		holdsNearly_ = worstFirst(sewn).size() <= fewFailures || curvature <= littleCurvature;
	}

	/// Whether few panels fail that were joined greedily, or there is little curvature to be rid of.
	bool holdsNearly() const { return holdsNearly_; }

private:
	template <class Work>
	void withProgress(const Progress& progress, const Work& work) {
		const Progress ofWhole = std::exchange(progress_, progress);
		work();
		progress_ = ofWhole;
	}

	Progress progress_; ///< of what goes on now
	PanelPlan plan_;
	bool joined_ = false, holdsNearly_ = true;
};

using Starts = std::vector<std::unique_ptr<Start>>;

/// Of seams in all, with as much more for each panel as a maker would give for one panel less.
double price(const CutSurface& surface) {
	constexpr double panelPrice = 0.1; // share of the seams
	return seamLength(surface) * (1 + panelPrice * surface.usedPanelCount());
}

/// Of what is to be cut, rad.
double curvatureOf(const TriangleMesh& mesh) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	return totalAbsoluteCurvature(angleDefects(assembly, assembly.originalPositions));
}

/// Clusters of several sizes. Where panels that are joined of the first do not hold nearly there are no
/// others.
Starts newStarts(const SearchInput& input, const Progress& progress) {
	Starts starts;
	std::set<std::vector<int>> begun; // what begins alike ends alike
	for (const double deviation : clusterDeviations(input)) {
		auto start = std::make_unique<Start>(input, progress);
		const bool isNew = begun.insert(start->plan().cluster(deviation)).second;
		if (!isNew && !start->plan().stopped())
			continue;
		starts.push_back(std::move(start));
		Start& last = *starts.back();
		if (starts.size() == 1 && !input.options.material.bounds.any() && !last.plan().stopped())
			last.joinGreedily(partOf(progress, 0, shareOfFirst));
		if (last.plan().stopped() || !last.holdsNearly())
			break;
	}
	return starts;
}

/// All joined, side by side, the most promising first: sewing takes longer than joining, and seldom changes
/// which is best.
void join(Starts& starts, const Progress& progress) {
	std::vector<Task> tasks;
	for (const std::unique_ptr<Start>& start : starts)
		tasks.push_back(start->joining());
	runTasks(tasks, 0, partOf(progress, shareOfFirst, shareOfJoining));
	std::stable_sort(starts.begin(), starts.end(),
					 [](const auto& a, const auto& b) { return price(a->surface()) < price(b->surface()); });
}

/// Whether panels that are yet to be sewn may come to more than what was found.
bool mayBeBetter(const CutSurface& surface, const FoundPanels& found) {
	constexpr double priceSewn = 0.85; // beside that before: seams become smooth
	return !found.hold || priceSewn * price(surface) < price(found.planned.front().surface);
}

FoundPanels searchInStages(const SearchInput& input, const Progress& progress) {
	PanelPlan plan(input, progress);
	plan.cluster(clusterDeviations(input).front());
	const bool hold = !plan.stopped() && plan.searchInStages();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

} // namespace

std::vector<double> clusterDeviations(const SearchInput& input) {
	constexpr int manyTriangles = 2000;
	const TriangleMesh& mesh = input.patches.mesh;
	if (mesh.triangleCount() <= manyTriangles)
		return {0.15, 0.25, 0.35, 0.08};
	if (input.options.material.bounds.any() || curvatureOf(mesh) > muchCurvature)
		return {0.15};
	return {0.15, 0.25, 0.35};
}

FoundPanels foundBy(const PanelPlan& plan, bool hold) {
	return {plan.found(), plan.sewn(), hold, plan.stopped(), {}};
}

FoundPanels stoppedPanels() {
	FoundPanels found;
	found.stopped = true;
	return found;
}

bool isBetter(const FoundPanels& a, const FoundPanels& b) {
	const CutSurface &first = a.planned.front().surface, &second = b.planned.front().surface;
	const int panels = first.usedPanelCount(), otherPanels = second.usedPanelCount();
	if (a.hold != b.hold)
		return a.hold;
	return panels != otherPanels ? panels < otherPanels : seamLength(first) < seamLength(second);
}

FoundPanels searchPanels(const SearchInput& input, const Progress& progress) {
	Starts starts = newStarts(input, progress);
	if (!starts.front()->holdsNearly())
		return searchInStages(input, partOf(progress, shareOfFirst, 1));
	if (starts.back()->plan().stopped())
		return stoppedPanels();
	join(starts, progress);
	std::optional<FoundPanels> found;
	double work = 0;
	for (std::size_t i = 0; i < starts.size(); ++i) {
		PanelPlan& plan = starts[i]->plan();
		const auto isPromising = [&](const CutSurface& surface) {
			return !found || work <= littleWork || mayBeBetter(surface, *found);
		};
		const bool hold = !starts[i]->stopped() && plan.search(isPromising);
		if (starts[i]->stopped())
			return stoppedPanels();
		if (found)
			addSearch(*found, foundBy(plan, hold));
		else
			found = foundBy(plan, hold);
		work += plan.work();
		if (i + 1 == starts.size() || seamChains(found->planned.front().surface).empty() ||
			(found->hold && work > muchWork) ||
			(work > littleWork && (i + 1 == mostSearches || !mayBeBetter(starts[i + 1]->surface(), *found))))
			break;
	}
	return std::move(*found);
}

} // namespace developable::detail
