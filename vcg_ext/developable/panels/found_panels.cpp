// SPDX-License-Identifier: GPL-3.0-or-later
// found_panels.cpp: searches that begin with clusters of several sizes, the most promising first.
#include "found_panels.h"

#include "mirror_plane.h"
#include "panel_plan.h"
#include "smoothed_patches.h"
#include "thinned_patches.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

constexpr double littleWork = 6e6; ///< see WorkBudget: some seconds
constexpr double muchWork = 5e7;   ///< see WorkBudget: a minute or two
constexpr int mostSearches = 2;    ///< of those that take longer
/// Of the panels that were joined first so many may not hold when they are sewn together: others can be
/// mended. Where more do not, as on shapes with limbs and fine detail, panels pull at each other all over.
constexpr std::size_t fewFailures = 2;
constexpr double littleCurvature =
	3 * 4 * pi; ///< inside panels, rad: as much as three closed convex shapes have
constexpr double shareOfFirst = 0.1, shareOfJoining = 0.7; ///< of the time of a search
/// Where there are more triangles, panels are looked for on fewer, with so many places, which move by less:
/// the detail that these have not takes room, too.
constexpr int mostTriangles = 8000, placesOfThinned = 2500;
constexpr double roomOfThinned = 0.9; ///< share of the limits

bool isBetter(const FoundPanels& a, const FoundPanels& b) {
	const CutSurface &first = a.planned.front().surface, &second = b.planned.front().surface;
	const int panels = first.usedPanelCount(), otherPanels = second.usedPanelCount();
	if (a.hold != b.hold)
		return a.hold;
	return panels != otherPanels ? panels < otherPanels : seamLength(first) < seamLength(second);
}

FoundPanels foundBy(const PanelPlan& plan, bool hold) {
	return {plan.found(), plan.sewn(), hold, plan.stopped(), {}};
}

FoundPanels stoppedPanels() {
	FoundPanels found;
	found.stopped = true;
	return found;
}

/// The better of two first, the other behind it.
void addSearch(FoundPanels& found, FoundPanels next) {
	if (isBetter(next, found))
		std::swap(found, next);
	if (next.hold)
		found.planned.insert(found.planned.end(), next.planned.begin(), next.planned.end());
}

std::string perCent(double share) {
	std::array<char, 32> text{};
	std::snprintf(text.data(), text.size(), "%.2g %%", 100 * share);
	return text.data();
}

/// A search, and where it begins.
class Start {
public:
	Start(const GivenPatches& patches, const std::vector<double>& limits, const CutOptions& options,
		  const Progress& progress)
		: progress_(progress), plan_(patches, limits, options, [this](double done, const std::string& what) {
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

/// Of clusters that searches begin with, see ClusterOptions. Where there are many triangles fine clusters
/// take long to join, and all do with a material: a test of strain takes many times as long.
std::vector<double> clusterDeviations(const GivenPatches& patches, const CutOptions& options) {
	constexpr int manyTriangles = 2000;
	if (patches.mesh.triangleCount() <= manyTriangles)
		return {0.15, 0.25, 0.35, 0.08};
	if (options.material.bounds.any())
		return {0.15};
	return {0.15, 0.25, 0.35};
}

/// Clusters of several sizes. Where panels that are joined of the first do not hold nearly there are no
/// others.
Starts newStarts(const GivenPatches& patches, const std::vector<double>& limits, const CutOptions& options,
				 const Progress& progress) {
	Starts starts;
	std::set<std::vector<int>> begun; // what begins alike ends alike
	for (const double deviation : clusterDeviations(patches, options)) {
		auto start = std::make_unique<Start>(patches, limits, options, progress);
		const bool isNew = begun.insert(start->plan().cluster(deviation)).second;
		if (!isNew && !start->plan().stopped())
			continue;
		starts.push_back(std::move(start));
		Start& last = *starts.back();
		if (starts.size() == 1 && !options.material.bounds.any() && !last.plan().stopped())
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

/// Nothing, unless the surface is developable between its sharp edges.
/// \param mirror  joins keep to it, or null
std::optional<FoundPanels> findStillPanels(const GivenPatches& patches, const std::vector<double>& limits,
										   const CutOptions& options, const MirrorPlane* mirror,
										   const Progress& progress) {
	PanelPlan plan(patches, limits, options, progress);
	const bool hold = mirror != nullptr ? plan.searchStill(*mirror) : plan.searchStill();
	if (hold || plan.stopped())
		return foundBy(plan, hold);
	return {};
}

FoundPanels searchInStages(const GivenPatches& patches, const std::vector<double>& limits,
						   const CutOptions& options, bool confirmed, const Progress& progress) {
	PanelPlan plan(patches, limits, options, progress);
	if (!confirmed)
		plan.trustBriefRuns();
	plan.cluster(clusterDeviations(patches, options).front());
	const bool hold = !plan.stopped() && plan.searchInStages();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

/// From clusters on.
/// \param confirmed  what is found should also hold as the user will have it
FoundPanels search(const GivenPatches& patches, const std::vector<double>& limits, const CutOptions& options,
				   bool confirmed, const Progress& progress) {
	Starts starts = newStarts(patches, limits, options, progress);
	if (!starts.front()->holdsNearly())
		return searchInStages(patches, limits, options, confirmed, partOf(progress, shareOfFirst, 1));
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

/// The first of which nearly all hold on what was given, too, else those of which most do.
void takeOverBest(PanelPlan& plan, const ThinnedPatches& thinned, const FoundPanels& found,
				  const CutOptions& options) {
	std::optional<CarriedPanels> best;
	std::size_t leastFailures = std::numeric_limits<std::size_t>::max();
	for (std::size_t i = 0; i < found.planned.size() && leastFailures > fewFailures && !plan.stopped(); ++i) {
		CarriedPanels carried = thinned.carriedBack(found.planned[i], options);
		plan.takeOver(carried);
		const std::size_t failures = worstFirst(plan.sewnAtFirst()).size();
		if (failures < leastFailures)
			best = std::move(carried);
		leastFailures = std::min(failures, leastFailures);
	}
	if (best)
		plan.takeOver(std::move(*best));
}

/// Where panels are is found with fewer triangles.
FoundPanels searchThinned(const GivenPatches& patches, const std::vector<double>& limits,
						  const CutOptions& options, const Progress& progress) {
	constexpr double shareOfSearch = 0.7;
	const ThinnedPatches thinned(patches, placesOfThinned);
	std::vector<double> thinnedLimits = thinned.limits(limits);
	for (double& limit : thinnedLimits)
		limit *= roomOfThinned;
	const FoundPanels found =
		search(thinned.patches(), thinnedLimits, options, false, partOf(progress, 0, shareOfSearch));
	if (found.stopped)
		return stoppedPanels();
	PanelPlan plan(patches, limits, options, partOf(progress, shareOfSearch, 1));
	takeOverBest(plan, thinned, found, options);
	const bool hold = !plan.stopped() && plan.finishTakenOver();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

/// With as many triangles as serve.
FoundPanels searchFor(const GivenPatches& patches, const std::vector<double>& limits,
					  const CutOptions& options, const Progress& progress) {
	if (patches.mesh.triangleCount() > mostTriangles)
		return searchThinned(patches, limits, options, progress);
	return search(patches, limits, options, true, progress);
}

/// Where panels are is found without detail.
FoundPanels searchSmoothed(const GivenPatches& patches, const SmoothedPatches& smoothed,
						   const std::vector<double>& limits, const CutOptions& options,
						   const Progress& progress) {
	constexpr double shareOfSearch = 0.8;
	const FoundPanels found =
		searchFor(smoothed.patches(), smoothed.limits(), options, partOf(progress, 0, shareOfSearch));
	if (found.stopped)
		return stoppedPanels();
	PanelPlan plan(patches, limits, options, partOf(progress, shareOfSearch, 1));
	const bool hold =
		plan.takeOver(std::vector{smoothed.carriedBack(found.planned.front())}) || plan.divide();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

} // namespace

FoundPanels findPanels(const GivenPatches& patches, const std::vector<double>& limits,
					   const CutOptions& options, const Progress& progress) {
	if (std::optional<FoundPanels> still = findStillPanels(patches, limits, options, nullptr, progress))
		return std::move(*still);
	const SmoothedPatches smoothed(patches, limits);
	if (smoothed.hadDetail())
		return searchSmoothed(patches, smoothed, limits, options, progress);
	return searchFor(patches, limits, options, progress);
}

FoundPanels findSymmetricPanels(const GivenPatches& patches, const std::vector<double>& limits,
								const CutOptions& options, const Progress& progress) {
	const MirrorPlane plane = mirrorPlane(patches.mesh);
	if (!plane.isSymmetric()) {
		FoundPanels found = findPanels(patches, limits, options, progress);
		found.notes.push_back("The surface is not symmetric: its best mirror image is " +
							  perCent(plane.meanDistance) + " of the diagonal away from it on average, and " +
							  perCent(plane.greatestDistance) +
							  " at most. It was cut as if symmetric panels had not been asked for.");
		return found;
	}
	if (std::optional<FoundPanels> still = findStillPanels(patches, limits, options, &plane, progress))
		return std::move(*still);
	PanelPlan plan(patches, limits, options, progress);
	const SymmetricOutcome outcome = plan.searchSymmetric(plane);
	FoundPanels found = foundBy(plan, outcome != SymmetricOutcome::Fails);
	if (outcome != SymmetricOutcome::Pairs)
		found.notes.emplace_back(noteOnDivided);
	return found;
}

} // namespace developable::detail
