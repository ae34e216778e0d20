// SPDX-License-Identifier: GPL-3.0-or-later
// found_panels.cpp: searches that begin with clusters of several sizes.
#include "found_panels.h"

#include "mirror_plane.h"
#include "panel_plan.h"

#include <array>
#include <cstdio>

namespace developable::detail {

namespace {

constexpr double deviations[] = {0.15, 0.25, 0.08}; ///< of clusters; see ClusterOptions
constexpr double littleWork = 3e5;                  ///< triangles, which take seconds

bool isBetter(const FoundPanels& a, const FoundPanels& b) {
	const int panels = a.planned.surface.usedPanelCount(), otherPanels = b.planned.surface.usedPanelCount();
	if (a.hold != b.hold)
		return a.hold;
	return panels != otherPanels ? panels < otherPanels
								 : seamLength(a.planned.surface) < seamLength(b.planned.surface);
}

std::string perCent(double share) {
	std::array<char, 32> text{};
	std::snprintf(text.data(), text.size(), "%.2g %%", 100 * share);
	return text.data();
}

} // namespace

FoundPanels findPanels(const GivenPatches& patches, const std::vector<double>& limits,
					   const CutOptions& options, const Progress& progress) {
	std::vector<FoundPanels> found;
	double work = 0;
	for (const double deviation : deviations) {
		PanelPlan plan(patches, limits, options, progress);
		const bool hold = plan.search(deviation);
		FoundPanels next{plan.planned(), hold, plan.stopped(), {}};
		if (found.empty() || next.stopped || isBetter(next, found.front())) {
			found.clear();
			found.push_back(std::move(next));
		}
		work += plan.work();
		if (plan.stopped() || work > littleWork || seamChains(plan.planned().surface).empty())
			break;
	}
	return std::move(found.front());
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
	FoundPanels found{plan.planned(), outcome != SymmetricOutcome::Fails, plan.stopped(), {}};
	if (outcome != SymmetricOutcome::Pairs)
		found.notes.emplace_back(
			"Not all panels mirror each other: what did not hold among the others had to be "
			"divided. A larger displacement may help.");
	return found;
}

} // namespace developable::detail
