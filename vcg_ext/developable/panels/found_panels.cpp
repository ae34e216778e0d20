// SPDX-License-Identifier: GPL-3.0-or-later
// found_panels.cpp: on which copies of the surface panels are looked for, and the way back from there.
#include "found_panels.h"

#include "mirror_plane.h"
#include "panel_search.h"
#include "sewn_failures.h"
#include "smoothed_patches.h"
#include "thinned_patches.h"

#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

namespace developable::detail {

namespace {

/// Where there are more triangles, panels are looked for on fewer, with so many places, which move by less:
/// the detail that these have not takes room, too.
constexpr int mostTriangles = 8000, placesOfThinned = 2500;
constexpr double roomOfThinned = 0.9; ///< share of the limits

std::string perCent(double share) {
	std::array<char, 32> text{};
	std::snprintf(text.data(), text.size(), "%.2g %%", 100 * share);
	return text.data();
}

/// Nothing, unless the surface is developable between its sharp edges.
/// \param mirror  joins keep to it, or null
std::optional<FoundPanels> findStillPanels(const SearchInput& input, const MirrorPlane* mirror,
										   const Progress& progress) {
	PanelPlan plan(input, progress);
	const bool hold = mirror != nullptr ? plan.searchStill(*mirror) : plan.searchStill();
	if (hold || plan.stopped())
		return foundBy(plan, hold);
	return {};
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
FoundPanels searchThinned(const SearchInput& input, const Progress& progress) {
	constexpr double shareOfSearch = 0.7;
	const ThinnedPatches thinned(input.patches, placesOfThinned);
	std::vector<double> thinnedLimits = thinned.limits(input.limits);
	for (double& limit : thinnedLimits)
		limit *= roomOfThinned;
	const FoundPanels found = searchPanels({thinned.patches(), thinnedLimits, input.options, false},
										   partOf(progress, 0, shareOfSearch));
	if (found.stopped)
		return stoppedPanels();
	PanelPlan plan(input, partOf(progress, shareOfSearch, 1));
	takeOverBest(plan, thinned, found, input.options);
	const bool hold = !plan.stopped() && plan.finishTakenOver();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

/// With as many triangles as serve.
FoundPanels searchFor(const SearchInput& input, const Progress& progress) {
	if (input.patches.mesh.triangleCount() > mostTriangles)
		return searchThinned(input, progress);
	return searchPanels(input, progress);
}

/// Where panels are is found without detail.
FoundPanels searchSmoothed(const SearchInput& input, const SmoothedPatches& smoothed,
						   const Progress& progress) {
	constexpr double shareOfSearch = 0.8;
	const std::vector<double> limits = smoothed.limits();
	const FoundPanels found =
		searchFor({smoothed.patches(), limits, input.options, false}, partOf(progress, 0, shareOfSearch));
	if (found.stopped)
		return stoppedPanels();
	PanelPlan plan(input, partOf(progress, shareOfSearch, 1));
	const bool hold =
		plan.takeOver(std::vector{smoothed.carriedBack(found.planned.front())}) || plan.divide();
	return plan.stopped() ? stoppedPanels() : foundBy(plan, hold);
}

} // namespace

FoundPanels findPanels(const SearchInput& input, const Progress& progress) {
	if (std::optional<FoundPanels> still = findStillPanels(input, nullptr, progress))
		return std::move(*still);
	const SmoothedPatches smoothed(input.patches, input.limits);
	if (smoothed.hadDetail())
		return searchSmoothed(input, smoothed, progress);
	return searchFor(input, progress);
}

FoundPanels findSymmetricPanels(const SearchInput& input, const Progress& progress) {
	const MirrorPlane plane = mirrorPlane(input.patches.mesh);
	if (!plane.isSymmetric()) {
		FoundPanels found = findPanels(input, progress);
		found.notes.push_back("The surface is not symmetric: its best mirror image is " +
							  perCent(plane.meanDistance) + " of the diagonal away from it on average, and " +
							  perCent(plane.greatestDistance) +
							  " at most. It was cut as if symmetric panels had not been asked for.");
		return found;
	}
	if (std::optional<FoundPanels> still = findStillPanels(input, &plane, progress))
		return std::move(*still);
	PanelPlan plan(input, progress);
	const SymmetricOutcome outcome = plan.searchSymmetric(plane);
	FoundPanels found = foundBy(plan, outcome != SymmetricOutcome::Fails);
	if (outcome != SymmetricOutcome::Pairs)
		found.notes.emplace_back(noteOnDivided);
	return found;
}

} // namespace developable::detail
