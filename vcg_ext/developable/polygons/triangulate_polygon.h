// SPDX-License-Identifier: GPL-3.0-or-later
// triangulate_polygon.h: the triangulation of one polygon in space.
#pragma once

#include "developable/mesh/mesh.h"

#include <optional>

namespace developable {

/// The constrained Delaunay triangulation of a polygon in its least-squares plane.
///
/// \param contour  3 x corners, in order, finite, any unit of length
/// \return         3 x (corners - 2), corners, turning as the contour does; nothing when the contour
///                 crosses or touches itself in the plane, or has fewer than 3 corners
std::optional<Eigen::Matrix3Xi> triangulatePolygon(const Positions& contour);

} // namespace developable
