// SPDX-License-Identifier: GPL-3.0-or-later
// panel_joining.h: panels are joined across their seams, the longest first, as long as that makes panels.
#pragma once

#include "panel_tests.h"
#include "seam_chains.h"

namespace developable::detail {

/// What was joined, in order: the half edges across which.
using Joins = std::vector<std::vector<int>>;

/// Joins panels across whole seams, greedily.
/// \param joins  grows by those that were made
void joinPanels(CutSurface& surface, PanelTests& tests, Joins& joins);

/// Takes back the join within a panel that was made nearest to a point.
/// \return whether there was any
bool takeBackJoin(CutSurface& surface, int panel, const Eigen::Vector3d& point, Joins& joins);

/// Where a whole seam can't go, a long part of it does, from one of its ends on; the rest stays as a dart.
/// \param joins  grows by those that were made
void joinWithDarts(CutSurface& surface, PanelTests& tests, Joins& joins);

} // namespace developable::detail
