// SPDX-License-Identifier: GPL-3.0-or-later
// cut_report.h: what a user is told of the panels.
#pragma once

#include "cut_into_panels.h"
#include "cut_surface.h"
#include "sewn_panels.h"

namespace developable::detail {

/// \param givenSeamLength  of seams that were there before
CutReport reportOf(const CutSurface& surface, const SewnPanels& sewn, double givenSeamLength,
				   const CutOptions& options);

} // namespace developable::detail
