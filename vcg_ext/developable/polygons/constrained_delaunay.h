// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_delaunay.h: the constrained Delaunay triangulation of a polygon in the plane.
#pragma once

#include <Eigen/Core>

namespace developable::detail {

/// True when a contour neither crosses nor touches itself, and has an area. Decided exactly.
/// \param contour  2 x corners, any unit of length
bool isSimplePolygon(const Eigen::Matrix2Xd& contour);

/// The triangulation of one simple polygon.
/// \param contour  2 x corners, any unit of length
/// \return         the triangles inside, 3 x (corners - 2), counterclockwise
Eigen::Matrix3Xi constrainedDelaunay(const Eigen::Matrix2Xd& contour);

} // namespace developable::detail
