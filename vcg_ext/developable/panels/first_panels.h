// SPDX-License-Identifier: GPL-3.0-or-later
// first_panels.h: from patches to the many panels that joining begins with.
#pragma once

#include "cut_into_panels.h"
#include "panel_tests.h"
#include "planned_surface.h"

namespace developable::detail {

/// Patches that are no panels become clusters of normals, and what is no panel then is divided until it is
/// one.
/// \param clusterDeviation  as in ClusterOptions
void makeFirstPanels(PlannedSurface& planned, PanelTests& tests, const CutOptions& options,
					 double clusterDeviation);

/// Divides a panel in two by its normals, if that is possible. \return whether it was
bool divideInTwo(PlannedSurface& planned, const CutOptions& options, int panel);

} // namespace developable::detail
