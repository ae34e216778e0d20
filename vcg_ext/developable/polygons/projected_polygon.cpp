// SPDX-License-Identifier: GPL-3.0-or-later
// projected_polygon.cpp: projection along the smallest of three principal axes, and sums of opposite angles.
#include "projected_polygon.h"

#include "developable/linear/linear.h"

#include <map>

namespace developable::detail {

Eigen::Matrix2Xd projectedContour(const Positions& contour) {
	Positions centred = contour.colwise() - contour.rowwise().mean().eval();
	const double size = centred.cwiseAbs().maxCoeff();
	if (size > 0)
		centred /= size;
	const Eigen::Matrix3d axes = symmetricEigen(centred * centred.transpose()).vectors;
	Eigen::Matrix2Xd projected = axes.rightCols<2>().transpose() * centred;
	double doubleArea = 0;
	for (Eigen::Index i = 0, last = projected.cols() - 1; i < projected.cols(); last = i++)
		doubleArea += projected(0, last) * projected(1, i) - projected(0, i) * projected(1, last);
	if (doubleArea < 0)
		projected.row(1) *= -1;
	return projected;
}

double delaunayTolerance(const Positions& contour) {
	double shortest = (contour.col(0) - contour.col(contour.cols() - 1)).norm();
	for (Eigen::Index i = 1; i < contour.cols(); ++i)
		shortest = std::min(shortest, (contour.col(i) - contour.col(i - 1)).norm());
	return std::min(1e-6 * contour.cwiseAbs().maxCoeff() / shortest, 1e-3);
}

std::set<Edge> diagonals(const Eigen::Matrix3Xi& triangles) {
	const int corners = static_cast<int>(triangles.cols()) + 2;
	std::set<Edge> result;
	for (const auto& triangle : triangles.colwise())
		for (int side = 0; side < 3; ++side) {
			const int start = triangle[side], end = triangle[nextCorner(side)];
			if (end != (start + 1) % corners)
				result.insert(edgeBetween(start, end));
		}
	return result;
}

bool isConstrainedDelaunay(const Eigen::Matrix2Xd& contour, const Eigen::Matrix3Xi& triangles,
						   double tolerance) {
	std::map<Edge, Eigen::Vector2d> oppositeAngle; // of the first triangle at an edge: cosine and sine
	for (const auto& triangle : triangles.colwise())
		for (int corner = 0; corner < 3; ++corner) {
			const int at = triangle[corner], next = triangle[nextCorner(corner)],
					  last = triangle[previousCorner(corner)];
			const Eigen::Vector2d a = (contour.col(next) - contour.col(at)).normalized();
			const Eigen::Vector2d b = (contour.col(last) - contour.col(at)).normalized();
			const Eigen::Vector2d angle(a.dot(b), a[0] * b[1] - a[1] * b[0]);
			if (!(angle[1] > 0))
				return false;
			const auto [other, isFirst] = oppositeAngle.emplace(edgeBetween(next, last), angle);
			if (isFirst)
				continue;
			const double sineOfSum = angle[1] * other->second[0] + angle[0] * other->second[1];
			if (sineOfSum < -tolerance)
				return false;
		}
	return true;
}

} // namespace developable::detail
