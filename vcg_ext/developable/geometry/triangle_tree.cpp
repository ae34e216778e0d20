// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_tree.cpp: the nearest points of triangles, and the search for the nearest of all.
#include "triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable::detail {
namespace {

Eigen::Vector3d nearestOnSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
								 const Eigen::Vector3d& end) {
	const Eigen::Vector3d along = end - start;
	const double length = along.squaredNorm();
	const double share = length > 0 ? std::clamp((point - start).dot(along) / length, 0.0, 1.0) : 0;
	return start + share * along;
}

/// vcglib has such a function too (PointDistanceBase), but it looks at one edge only when the point lies
/// outside two, which is too far at an obtuse corner.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
								  const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
	const Eigen::Vector3d normal = (b - a).cross(c - a);
	const auto isInside = [&](const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
		return (end - start).cross(point - start).dot(normal) > 0;
	};
	if (isInside(a, b) && isInside(b, c) && isInside(c, a)) {
		// Of length 1 first: the sixth power of a length leaves the range of numbers soon.
		const Eigen::Vector3d direction = normal / normal.norm();
		return point - direction.dot(point - a) * direction;
	}
	Eigen::Vector3d nearest = nearestOnSegment(point, a, b);
	for (const Eigen::Vector3d& other : {nearestOnSegment(point, b, c), nearestOnSegment(point, c, a)})
		if ((point - other).squaredNorm() < (point - nearest).squaredNorm())
			nearest = other;
	return nearest;
}

} // namespace

TriangleTree::TriangleTree(const Positions& vertices, const Eigen::Matrix3Xi& triangles)
	: vertices_(vertices), triangles_(triangles) {
	std::vector<int> numbers(triangles.cols());
	std::vector<Eigen::AlignedBox3d> boxes(triangles.cols());
	for (int t = 0; t < triangles.cols(); ++t) {
		numbers[t] = t;
		for (const int vertex : triangles.col(t))
			boxes[t].extend(vertices.col(vertex));
	}
	tree_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

int TriangleTree::nearestTriangleTo(const Eigen::Vector3d& point) {
	squaredDistance_ = (point - nearestIn(nearest_, point)).squaredNorm();
	descend(tree_.getRootIndex(), point);
	return nearest_;
}

Eigen::Vector3d TriangleTree::nearestTo(const Eigen::Vector3d& point) {
	return nearestIn(nearestTriangleTo(point), point);
}

Eigen::Vector3d TriangleTree::nearestIn(int triangle, const Eigen::Vector3d& point) const {
	const auto corners = triangles_.col(triangle);
	return nearestOnTriangle(point, vertices_.col(corners[0]), vertices_.col(corners[1]),
							 vertices_.col(corners[2]));
}

void TriangleTree::descend(int node, const Eigen::Vector3d& point) {
	const int *box = nullptr, *boxEnd = nullptr, *triangle = nullptr, *triangleEnd = nullptr;
	tree_.getChildren(node, box, boxEnd, triangle, triangleEnd);
	for (; triangle != triangleEnd; ++triangle) {
		const double squared = (point - nearestIn(*triangle, point)).squaredNorm();
		if (squared < squaredDistance_) {
			squaredDistance_ = squared;
			nearest_ = *triangle;
		}
	}
	const auto distanceTo = [&](const int* child) {
		return tree_.getVolume(*child).squaredExteriorDistance(point);
	};
	if (boxEnd - box == 2) {
		const double first = distanceTo(box), second = distanceTo(box + 1);
		const bool swapped = second < first;
		visit(box[swapped], swapped ? second : first, point);
		visit(box[!swapped], swapped ? first : second, point);
	} else if (boxEnd - box == 1) {
		visit(*box, distanceTo(box), point);
	}
}

void TriangleTree::visit(int node, double squaredDistanceToBox, const Eigen::Vector3d& point) {
	if (squaredDistanceToBox < squaredDistance_)
		descend(node, point);
}

} // namespace developable::detail
