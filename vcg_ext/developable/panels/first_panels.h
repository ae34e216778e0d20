// SPDX-License-Identifier: GPL-3.0-or-later
// first_panels.h: from patches to the many panels that joining begins with.
#pragma once

#include "cut_into_panels.h"
#include "panel_tests.h"
#include "planned_surface.h"
#include "sharp_features.h"

#include <optional>

namespace developable::detail {

/// Patches that are no panels are divided by their creases, what is none then in clusters of normals, and the
/// rest until each is one.
/// \param clusterDeviation  as in ClusterOptions
void makeFirstPanels(PlannedSurface& planned, PanelTests& tests, const CutOptions& options,
					 double clusterDeviation);

/// Cuts what is no panel along every sharp edge. Where what is between these has no curvature, it is divided
/// until each is a panel that hardly moves.
/// \param still  the share of what panels may move that hardly is any; limits are that share then
/// \return       the edges along which it was cut, all of which are alone; nothing where there is curvature
std::optional<SharpFeatures> makeStillPanels(PlannedSurface& planned, PanelTests& tests,
											 const CutOptions& options, double still);

/// Divides a panel in two by its normals, if that is possible. \return whether it was
bool divideInTwo(PlannedSurface& planned, const CutOptions& options, int panel);

} // namespace developable::detail
