// SPDX-License-Identifier: GPL-3.0-or-later
// surface_distance.h: how far points are from a triangle surface (the distance error map of Fig. 8 and 9).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The point of a surface that is nearest to each point. Points are taken in an order in which those
/// that follow each other are near each other, as the last answer bounds the next search: 1 to 5 µs each.
/// vcglib's grid is as quick near a surface, but takes a hundred times as long at some distance from it, as
/// it looks at every cell of a growing cube; its box tree allocates as many pointers as there are triangles
/// for every point.
///
/// \param points     3 x any number, anywhere, in the surface's unit of length
/// \param vertices   3 x vertices of the surface
/// \param triangles  3 x triangles, at least one; all coordinates finite
Positions nearestOnSurface(const Positions& points, const Positions& vertices,
						   const Eigen::Matrix3Xi& triangles);

/// How far that is: per point, in the same unit, 0 or more.
Eigen::VectorXd distancesToSurface(const Positions& points, const Positions& vertices,
								   const Eigen::Matrix3Xi& triangles);

/// The triangle that is nearest to each point, one of those that are.
std::vector<int> nearestTriangles(const Positions& points, const Positions& vertices,
								  const Eigen::Matrix3Xi& triangles);

} // namespace developable
