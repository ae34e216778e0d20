// SPDX-License-Identifier: GPL-3.0-or-later
// triangulate_polygon.cpp: a polygon projected, refused unless it is simple, and triangulated.
#include "triangulate_polygon.h"

#include "constrained_delaunay.h"
#include "projected_polygon.h"

namespace developable {

std::optional<Eigen::Matrix3Xi> triangulatePolygon(const Positions& contour) {
	if (contour.cols() < 3)
		return std::nullopt;
	const Eigen::Matrix2Xd projected = detail::projectedContour(contour);
	if (!detail::isSimplePolygon(projected))
		return std::nullopt;
	return detail::constrainedDelaunay(projected);
}

} // namespace developable
