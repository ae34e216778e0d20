// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_layout.h: the layout of a panel that keeps its triangles within the bounds of a material.
#pragma once

#include "grain_directions.h"
#include "panel_mesh.h"

namespace developable::detail {

/// From a layout without flipped triangles to the one of least Σ (flattened length − length)² among those
/// within the bounds, or, where there is none, to one that exceeds them little.
/// \param longestSide  vertices of the panel; see grainDirection
/// \param onlyWithin   whether to give up where no layout within the bounds can be hoped for
PlanePositions boundedLayout(const PanelMesh& panel, const PlanePositions& start, const StrainBounds& bounds,
							 const Grain& grain, const std::array<int, 2>& longestSide, bool onlyWithin);

} // namespace developable::detail
