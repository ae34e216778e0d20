// SPDX-License-Identifier: GPL-3.0-or-later
// cut_sides.h: labels that tell the two sides of every slit and dart apart.
#pragma once

#include "cut_surface.h"

namespace developable::detail {

/// Each panel falls apart into the parts that are nearest to one side of one of its slits and darts: on the
/// other side, and behind a dart's tip, there is another.
/// \return  per triangle, from 0
std::vector<int> cutSides(const CutSurface& surface);

} // namespace developable::detail
