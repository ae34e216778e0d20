// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_pieces.h: a triangle that curves cross, as smaller triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace developable::detail {

/// Divides a convex polygon along its chords, and the rest of it such that the flattest triangle is as high
/// as can be beside its longest side. Points on a straight side are corners, too.
/// \param points  3 x corners, in order
/// \param chords  pairs of corners that cross nowhere
/// \return        corners of each triangle, in the same sense as the polygon's
std::vector<std::array<int, 3>> trianglesOfPolygon(const Eigen::Matrix3Xd& points,
												   const std::vector<std::pair<int, int>>& chords);

} // namespace developable::detail
