// SPDX-License-Identifier: GPL-3.0-or-later
// ring_slits.h: the shortest slits that make a disk of a ring.
#pragma once

#include "cut_surface.h"

namespace developable::detail {

/// Cuts a panel from one of its borders to another, where these are nearest to each other, again and again.
/// \param euler  the characteristic that is wanted, 1 of a disk
void slitHoles(CutSurface& surface, int panel, int euler = 1);

/// The same with all panels of some triangles.
void slitPanelsOf(CutSurface& surface, const std::vector<int>& triangles);

} // namespace developable::detail
