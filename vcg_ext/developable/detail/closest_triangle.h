// SPDX-License-Identifier: GPL-3.0-or-later
// closest_triangle.h: the distance of a point to a triangle, in the form that vcglib's spatial indices ask for.
#pragma once

#include "../triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vcg/space/box3.h>

namespace developable::detail {

inline double squaredDistanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
									   const Eigen::Vector3d& end) {
	const Eigen::Vector3d along = end - start, from = point - start;
	const double length = along.squaredNorm();
	const double share = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
	return (from - share * along).squaredNorm();
}

/// vcglib has such a function too (PointDistanceBase), but it looks at one edge only when the point lies outside
/// two, which is too far at an obtuse corner.
inline double squaredDistanceToTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
										const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
	const Eigen::Vector3d normal = (b - a).cross(c - a);
	const auto isInside = [&](const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
		return (end - start).cross(point - start).dot(normal) > 0;
	};
	if (isInside(a, b) && isInside(b, c) && isInside(c, a)) {
		const double height = normal.dot(point - a);
		return height * height / normal.squaredNorm();
	}
	return std::min({squaredDistanceToSegment(point, a, b), squaredDistanceToSegment(point, b, c),
					 squaredDistanceToSegment(point, c, a)});
}

/// A triangle with the members that vcglib's box tree asks of what it holds.
class IndexedTriangle {
public:
	using ScalarType = double;

	IndexedTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
		: corners_{a, b, c} {}

	vcg::Point3d cP(int corner) const { return toPoint(corners_[corner]); }
	void GetBBox(vcg::Box3d& box) const {
		const auto& [a, b, c] = corners_;
		box = vcg::Box3d(toPoint(a.cwiseMin(b).cwiseMin(c)), toPoint(a.cwiseMax(b).cwiseMax(c)));
	}

	double distance(const Eigen::Vector3d& point) const {
		return std::sqrt(squaredDistanceToTriangle(point, corners_[0], corners_[1], corners_[2]));
	}

private:
	static vcg::Point3d toPoint(const Eigen::Vector3d& point) { return {point[0], point[1], point[2]}; }

	std::array<Eigen::Vector3d, 3> corners_;
};

/// Lowers `least` to the triangle's distance where the triangle is nearer.
struct DistanceToTriangle {
	using QueryType = vcg::Point3d;

	bool operator()(const IndexedTriangle& triangle, const vcg::Point3d& point, double& least,
					vcg::Point3d& nearest) const {
		const double distance = triangle.distance(Eigen::Vector3d(point[0], point[1], point[2]));
		if (!(distance < least))
			return false;
		least = distance;
		nearest = point; // which point it is nobody asks, but vcglib copies it
		return true;
	}
};

} // namespace developable::detail
