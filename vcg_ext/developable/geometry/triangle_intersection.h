// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_intersection.h: whether two triangles of a surface cut each other elsewhere than where they are
// joined.
#pragma once

#include "developable/mesh/mesh.h"

#include <Eigen/Geometry>

namespace developable {

/// The three corners of a triangle with its normal, and the object vertices they lie at.
struct PlacedTriangle {
	Eigen::Vector3i places;
	Eigen::Matrix3d corners;
	Eigen::Vector3d normal;

	PlacedTriangle(const Eigen::Vector3i& at, const Eigen::Matrix3d& points)
		: places(at), corners(points),
		  normal((corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0))) {}

	/// Whether others' corners all lie beyond the plane that stands on one of its edges, apart from those
	/// that are the edge's ends. Those of most neighbours on a surface do.
	/// \param otherPlaces  of the corners
	/// \param others       3 x corners
	template <class Places, class Corners>
	bool hasBeyondAnEdge(const Places& otherPlaces, const Corners& others) const {
		for (int first = 0; first < 3; ++first) {
			const int second = nextCorner(first), count = static_cast<int>(otherPlaces.size());
			const Eigen::Vector3d at = corners.col(first), outward = (corners.col(second) - at).cross(normal);
			bool beyond = true;
			for (int i = 0; beyond && i < count; ++i)
				beyond = outward.dot(others.col(i) - at) > 0 || otherPlaces[i] == places[first] ||
						 otherPlaces[i] == places[second];
			if (beyond)
				return true;
		}
		return false;
	}

	/// Whether a direction in its plane points from a corner strictly into it.
	bool hasInside(int corner, const Eigen::Vector3d& direction) const {
		const Eigen::Vector3d at = corners.col(corner), across = normal.cross(direction);
		return across.dot(corners.col(nextCorner(corner)) - at) < 0 &&
			   across.dot(corners.col(previousCorner(corner)) - at) > 0;
	}
};

namespace detail {

/// Which corners of two triangles lie at the same object vertices.
struct SharedCorners {
	int count = 0, ofA = 0, ofB = 0; ///< the corners: of the last pair found

	SharedCorners(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
		for (int i = 0; i < 3; ++i)
			for (int j = 0; j < 3; ++j)
				if (a[i] == b[j]) {
					++count;
					ofA = i;
					ofB = j;
				}
	}
};

/// Whether two triangles that share no object vertex cut each other.
bool intersectUnjoined(const PlacedTriangle& a, const PlacedTriangle& b);

} // namespace detail

/// Whether two triangles cut each other. Those that share one vertex do where the line of both their planes
/// runs into both corners; those that share an edge only when folded flat, which no move hits exactly.
inline bool intersect(const PlacedTriangle& a, const PlacedTriangle& b) {
	const detail::SharedCorners shared(a.places, b.places);
	if (shared.count > 1 || a.hasBeyondAnEdge(b.places, b.corners))
		return false;
	if (shared.count == 1) {
		const Eigen::Vector3d line = a.normal.cross(b.normal);
		return (a.hasInside(shared.ofA, line) && b.hasInside(shared.ofB, line)) ||
			   (a.hasInside(shared.ofA, -line) && b.hasInside(shared.ofB, -line));
	}
	return detail::intersectUnjoined(a, b);
}

} // namespace developable
