// SPDX-License-Identifier: GPL-3.0-or-later
// selected_whole.h: selected triangles that no seam may cross.
#pragma once

#include "cut_into_panels.h"
#include "planned_surface.h"

namespace developable::detail {

/// Per triangle whether no seam may cross it; empty when none is to be kept whole.
std::vector<char> keptTriangles(const PlannedSurface& planned, const CutOptions& options);

/// Each connected part of what is selected has one label, that of most of its area, if it is to stay whole.
/// \param labels  per triangle
std::vector<int> withSelectedWhole(const PlannedSurface& planned, const CutOptions& options,
								   std::vector<int> labels);

} // namespace developable::detail
