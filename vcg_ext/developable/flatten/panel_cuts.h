// SPDX-License-Identifier: GPL-3.0-or-later
// panel_cuts.h: the short paths along which a panel with holes is cut open into a disk.
#pragma once

#include "panel_mesh.h"

namespace developable::detail {

/// Where to cut a panel. Each path is half edges, one of every edge of the path.
struct PanelCuts {
	std::vector<std::vector<int>> needed; ///< to holes that no flat sheet can have
	std::vector<std::vector<int>> atMost; ///< to the other holes: only a disk needs these
};

/// Chooses where to cut. A hole in a flat sheet turns by -2π in all; what it turns by beyond that is the
/// total curvature that it stands for (Gauss and Bonnet): 0 for a window in a sheet, 2π for the end of a
/// tube.
///
/// \param loops              the panel's boundary loops
/// \param greatestCurvature  rad; a hole that stands for more is cut open in any case
PanelCuts chooseCuts(const PanelMesh& panel, const std::vector<std::vector<int>>& loops,
					 double greatestCurvature);

} // namespace developable::detail
