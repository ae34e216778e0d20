// SPDX-License-Identifier: GPL-3.0-or-later
// small_panels.h: panels that are too small to be sewn in.
#pragma once

#include "join_history.h"
#include "panel_tests.h"

#include <set>

namespace developable::detail {

/// The share of its patch's area that a panel has at least, unless the patch is one panel.
constexpr double leastPanelShare = 0.01;

/// Panels below the least share, the smallest first.
std::vector<int> smallPanels(const CutSurface& surface);

/// The neighbours of a panel, the largest first.
std::vector<int> neighboursOf(const CutSurface& surface, int panel);

/// Half edges of one panel beside another.
std::vector<int> halfEdgesBetween(const CutSurface& surface, int panel, int other);

/// Divides two panels anew: one keeps the triangles given, the other has the rest.
/// \param seam  all half edges between them
/// \return      what they are then: two, unless one fell apart or is gone
std::set<int> divideAnew(CutSurface& surface, const std::vector<int>& seam, const std::set<int>& own);

/// Panels that are much smaller yet go to the neighbour with the longest border, where both are one panel
/// then, if with a little more room: seams that are drawn anew move them by more.
void joinSlivers(CutSurface& surface, PanelTests& tests, JoinHistory& history);

/// Small panels take triangles from a neighbour, the nearest first, until they are large enough, where both
/// are panels then.
/// \param held  per triangle whether it has to stay with others; or empty
void growSmallPanels(CutSurface& surface, PanelTests& tests, const std::vector<char>& held);

} // namespace developable::detail
