// SPDX-License-Identifier: GPL-3.0-or-later
// taken_back_joins.h: panels that do not hold, sewn together, fall apart again.
#pragma once

#include "join_history.h"
#include "planned_surface.h"
#include "sewn_panels.h"

namespace developable::detail {

/// The panel of a surface that was there before faces were split which has most of a panel that is there
/// now.
int panelBefore(const PlannedSurface& before, const PlannedSurface& now, int panel);

/// Of panels that do not hold the last join of two parts of a size to be seen is taken back.
/// \param surface  as it was before its seams were drawn
/// \param panels   of that surface, each once
/// \return         whether there was any such join
bool takeBackLastJoins(CutSurface& surface, const std::vector<int>& panels, JoinHistory& history);

/// Panels that fail only for they overlap themselves when laid flat are divided there.
/// \param overlaps  by panel, two points that lie upon each other then
/// \return          whether any could be
bool divideOverlapping(CutSurface& surface, const std::map<int, std::array<Eigen::Vector3d, 2>>& overlaps,
					   JoinHistory& history);

} // namespace developable::detail
