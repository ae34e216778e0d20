// SPDX-License-Identifier: GPL-3.0-or-later
// spatial_order.h: an order of points in which near points mostly get near numbers.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The points along a Z-order curve: sorted by the bits of their coordinates, those of the three taken in
/// turn, the highest first.
/// \return  per number in the new order, the point
std::vector<int> spatialOrder(const Positions& points);

} // namespace developable
