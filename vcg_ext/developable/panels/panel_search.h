// SPDX-License-Identifier: GPL-3.0-or-later
// panel_search.h: from clusters of several sizes to panels that hold.
#pragma once

#include "found_panels.h"
#include "panel_plan.h"

namespace developable::detail {

/// Of the panels that were joined first so many may not hold when they are sewn together: others can be
/// mended. Where more do not, as on shapes with limbs and fine detail, panels pull at each other all over.
inline constexpr std::size_t fewFailures = 2;

/// Of clusters that searches begin with, see ClusterOptions, one search for each. Where there are many
/// triangles fine clusters take long to join, and all do with limbs or much detail, or a material: a test of
/// strain takes many times as long.
std::vector<double> clusterDeviations(const SearchInput& input);

FoundPanels foundBy(const PanelPlan& plan, bool hold);
FoundPanels stoppedPanels();

/// What holds, fewer panels, shorter seams.
bool isBetter(const FoundPanels& a, const FoundPanels& b);

/// From clusters on, those first that promise most.
FoundPanels searchPanels(const SearchInput& input, const Progress& progress);

} // namespace developable::detail
