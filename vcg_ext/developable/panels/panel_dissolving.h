// SPDX-License-Identifier: GPL-3.0-or-later
// panel_dissolving.h: panels that go to their neighbours, cluster by cluster.
#pragma once

#include "join_history.h"
#include "panel_tests.h"

namespace developable::detail {

/// Joining is greedy: two panels that can't be one may still be too many. A panel falls apart into the
/// clusters that it was joined from, and its neighbours take what they can; what is left is joined again.
/// That is kept where it leaves fewer panels, or as many with shorter seams. The smallest panels come first,
/// until none makes a difference. \param clusters  per triangle
void dissolvePanels(CutSurface& surface, const std::vector<int>& clusters, PanelTests& tests,
					JoinHistory& history);

} // namespace developable::detail
