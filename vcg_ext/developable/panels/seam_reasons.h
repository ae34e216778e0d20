// SPDX-License-Identifier: GPL-3.0-or-later
// seam_reasons.h: why panels are no larger than they are.
#pragma once

#include "panel_tests.h"
#include "sewn_panels.h"

namespace developable::detail {

/// Says of each panel that holds what would come of it without its longest seam (or slit, or dart): the panel
/// that it would be is tested. A panel without any that was added has nothing to say.
void explainSeams(CutSurface& surface, PanelTests& tests, SewnPanels& sewn);

} // namespace developable::detail
