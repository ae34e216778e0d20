// SPDX-License-Identifier: GPL-3.0-or-later
// overlap_division.h: a panel that overlaps itself when laid flat, divided between the two places.
#pragma once

#include "cut_surface.h"

#include <array>

namespace developable::detail {

/// Divides a panel in two, where ways from two of its points are equally long.
/// \param points  of which triangles of the panel are near
/// \return        whether it could be divided: the points are at different triangles
bool divideBetween(CutSurface& surface, int panel, const std::array<Eigen::Vector3d, 2>& points);

} // namespace developable::detail
