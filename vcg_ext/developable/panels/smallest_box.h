// SPDX-License-Identifier: GPL-3.0-or-later
// smallest_box.h: how large points are, however they are turned.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable::detail {

/// The least diagonal found of a box round some points, along any axes: no turn of the points changes it, as
/// far as a search by steps finds the least. Not more than along the axes that they have.
double smallestBoxDiagonal(const Positions& points);

} // namespace developable::detail
