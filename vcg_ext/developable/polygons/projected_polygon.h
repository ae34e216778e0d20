// SPDX-License-Identifier: GPL-3.0-or-later
// projected_polygon.h: a polygon in its least-squares plane, and whether its triangles are constrained
// Delaunay.
#pragma once

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <set>
#include <utility>

namespace developable::detail {

/// Two corners of a contour, or two vertices of a mesh: the smaller one first.
using Edge = std::pair<int, int>;

inline Edge edgeBetween(int a, int b) {
	return std::minmax(a, b);
}

/// A contour in its least-squares plane, counterclockwise if it is simple, centred, and of a size about 1.
/// \param contour  3 x corners, any unit of length, finite
/// \return         2 x corners, dimensionless
Eigen::Matrix2Xd projectedContour(const Positions& contour);

/// By how much the sum of the two angles opposite a diagonal may exceed π, rad, as far as coordinates in
/// single precision can tell. So corners on a circle, as every rectangle's are, keep the diagonals that they
/// have whatever the rounding, and hosts of single and double precision agree.
double delaunayTolerance(const Positions& contour);

/// The edges of a polygon's triangles that are not on its contour; triangles and edges by corners of the
/// contour.
std::set<Edge> diagonals(const Eigen::Matrix3Xi& triangles);

/// True when every triangle turns counterclockwise and the angles opposite each diagonal add up to at most π
/// and the tolerance: then all empty circumcircles follow.
/// \param contour    2 x corners
/// \param triangles  by corners of the contour
/// \param tolerance  rad
bool isConstrainedDelaunay(const Eigen::Matrix2Xd& contour, const Eigen::Matrix3Xi& triangles,
						   double tolerance);

} // namespace developable::detail
