// SPDX-License-Identifier: GPL-3.0-or-later
// found_panels.cpp: searches that begin with clusters of several sizes.
#include "found_panels.h"

#include "mirror_plane.h"
#include "panel_plan.h"

#include <array>
#include <cstdio>
#include <optional>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

constexpr double clusterDeviations[] = {0.15, 0.25, 0.08}; ///< of clusters; see ClusterOptions
constexpr double littleWork = 3e5;                         ///< triangles, which take seconds

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

} // namespace

FoundPanels findPanels(const GivenPatches& patches, const std::vector<double>& limits,
					   const CutOptions& options, const Progress& progress) {
	std::optional<FoundPanels> found;
	std::set<std::vector<int>> begun; // what begins alike ends alike
	double work = 0;
	for (const double deviation : clusterDeviations) {
		PanelPlan plan(patches, limits, options, progress);
		if (!begun.insert(plan.cluster(deviation)).second && !plan.stopped())
			continue;
		const bool hold = plan.search();
		if (plan.stopped())
			return foundBy(plan, hold);
		if (found)
			addSearch(*found, foundBy(plan, hold));
		else
			found = foundBy(plan, hold);
		work += plan.work();
		if (work > littleWork || seamChains(plan.planned().surface).empty())
			break;
	}
	return std::move(*found);
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
	PanelPlan plan(patches, limits, options, progress);
	const SymmetricOutcome outcome = plan.searchSymmetric(plane);
	FoundPanels found = foundBy(plan, outcome != SymmetricOutcome::Fails);
	if (outcome != SymmetricOutcome::Pairs)
		found.notes.emplace_back(
			"Not all panels mirror each other: what did not hold among the others had to be "
			"divided. A larger displacement may help.");
	return found;
}

} // namespace developable::detail
