// SPDX-License-Identifier: GPL-3.0-or-later
// contours.h: polygons in the plane, and what makes their triangulation constrained Delaunay.
#pragma once

#include "developable/polygons/projected_polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>
#include <utility>

namespace developable::test {

using Contour = Eigen::Matrix2Xd;
using Edges = std::set<std::pair<int, int>>;

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
	return a[0] * b[1] - a[1] * b[0];
}

inline double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
	return cross(b - a, c - a) / 2;
}

inline double area(const Contour& contour) {
	double sum = 0;
	for (int i = 0; i < contour.cols(); ++i)
		sum += cross(contour.col(i), contour.col((i + 1) % contour.cols())) / 2;
	return sum;
}

/// In the plane z = 0.
inline Positions inSpace(const Contour& contour) {
	Positions positions = Positions::Zero(3, contour.cols());
	positions.topRows<2>() = contour;
	return positions;
}

inline Contour points(std::initializer_list<Eigen::Vector2d> list) {
	Contour contour(2, list.size());
	int next = 0;
	for (const auto& point : list)
		contour.col(next++) = point;
	return contour;
}

inline Contour comb(int teeth) {
	Contour contour(2, 3 * teeth + 2);
	int next = 0;
	for (int tooth = 0; tooth < teeth; ++tooth) {
		contour.col(next++) << tooth, 1;
		contour.col(next++) << tooth + 0.4, 1;
		contour.col(next++) << tooth + 0.7, 8;
	}
	contour.col(next++) << teeth, 1;
	contour.col(next++) << 0.5 * teeth, 0;
	return contour.rowwise().reverse(); // counterclockwise
}

/// True when no side of the contour lies between a point within it and a corner.
inline bool seesEachOther(const Contour& contour, const Eigen::Vector2d& from, int corner) {
	const int count = static_cast<int>(contour.cols());
	const Eigen::Vector2d to = contour.col(corner);
	for (int i = 0; i < count; ++i) {
		const int next = (i + 1) % count;
		if (i == corner || next == corner)
			continue;
		const Eigen::Vector2d a = contour.col(i), b = contour.col(next);
		if (area(from, to, a) * area(from, to, b) <= 0 && area(a, b, from) * area(a, b, to) <= 0)
			return false;
	}
	return true;
}

inline bool insideCircumcircle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
							   const Eigen::Vector2d& point) {
	Eigen::Matrix3d m;
	for (const auto& [row, corner] : {std::make_pair(0, a), std::make_pair(1, b), std::make_pair(2, c)}) {
		const Eigen::Vector2d d = corner - point;
		m.row(row) << d[0], d[1], d.squaredNorm();
	}
	return m.determinant() > 1e-9;
}

/// The definition: the triangles fill the polygon, and no corner inside the circumcircle of a triangle is
/// seen from within that triangle.
inline void expectConstrainedDelaunay(const Contour& contour, const Eigen::Matrix3Xi& triangles) {
	ASSERT_EQ(triangles.cols(), contour.cols() - 2);
	double sum = 0;
	for (const auto& t : triangles.colwise()) {
		const Eigen::Vector2d a = contour.col(t[0]), b = contour.col(t[1]), c = contour.col(t[2]);
		EXPECT_GT(area(a, b, c), 0);
		sum += area(a, b, c);
		for (int corner = 0; corner < contour.cols(); ++corner) {
			if (corner == t[0] || corner == t[1] || corner == t[2] ||
				!insideCircumcircle(a, b, c, contour.col(corner)))
				continue;
			for (const Eigen::Vector3d& at : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(8, 1, 1),
											  Eigen::Vector3d(1, 8, 1), Eigen::Vector3d(1, 1, 8)}) {
				const Eigen::Vector2d within = (at[0] * a + at[1] * b + at[2] * c) / at.sum();
				EXPECT_FALSE(seesEachOther(contour, within, corner))
					<< "corner " << corner << ", triangle " << t.transpose();
			}
		}
	}
	EXPECT_NEAR(sum, area(contour), 1e-12 * contour.cols() * contour.cwiseAbs().maxCoeff());
}

inline Edges diagonalsOf(const Eigen::Matrix3Xi& triangles) {
	const auto edges = detail::diagonals(triangles);
	return Edges(edges.begin(), edges.end());
}

/// Four corners in convex position whose Delaunay diagonal is the one between 1 and 3.
inline const Contour kite = points({{-2, 0}, {0, -1}, {2, 0}, {0, 1}});

} // namespace developable::test
