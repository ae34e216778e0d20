// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_pieces.cpp: chord by chord, then the best triangulation by dynamic programming.
#include "triangle_pieces.h"

#include <algorithm>

namespace developable::detail {

namespace {

using Polygon = std::vector<int>; // corners, in order

/// The polygon on either side of a chord.
std::array<Polygon, 2> partsBeside(const Polygon& polygon, std::size_t first, std::size_t second) {
	std::array<Polygon, 2> parts;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		if (i >= first && i <= second)
			parts[0].push_back(polygon[i]);
		if (i <= first || i >= second)
			parts[1].push_back(polygon[i]);
	}
	return parts;
}

/// Pieces that no chord divides.
void divide(const Polygon& polygon, const std::vector<std::pair<int, int>>& chords,
			std::vector<Polygon>& pieces) {
	for (const auto& [a, b] : chords) {
		const auto atA = std::find(polygon.begin(), polygon.end(), a);
		const auto atB = std::find(polygon.begin(), polygon.end(), b);
		if (atA == polygon.end() || atB == polygon.end())
			continue;
		const std::size_t first = std::min(atA, atB) - polygon.begin();
		const std::size_t second = std::max(atA, atB) - polygon.begin();
		if (second - first < 2 || second - first + 1 == polygon.size())
			continue; // a side by now
		for (const Polygon& part : partsBeside(polygon, first, second))
			divide(part, chords, pieces);
		return;
	}
	pieces.push_back(polygon);
}

/// Of the height to the longest side.
double heightRatio(const Eigen::Matrix3Xd& points, int a, int b, int c) {
	const Eigen::Vector3d u = points.col(b) - points.col(a), v = points.col(c) - points.col(a);
	const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
	return longest > 0 ? u.cross(v).norm() / longest : 0;
}

/// Of all triangulations the one whose worst triangle is best.
class BestTriangulation {
public:
	BestTriangulation(const Eigen::Matrix3Xd& points, const Polygon& polygon)
		: polygon_(polygon), count_(static_cast<int>(polygon.size())), best_(count_ * count_, 1),
		  apex_(count_ * count_, -1) {
		for (int span = 2; span < count_; ++span)
			for (int i = 0; i + span < count_; ++i)
				for (int k = i + 1; k < i + span; ++k) {
					const int j = i + span;
					const double worst = std::min({heightRatio(points, polygon[i], polygon[k], polygon[j]),
												   best_[i * count_ + k], best_[k * count_ + j]});
					if (apex_[i * count_ + j] < 0 || worst > best_[i * count_ + j]) {
						best_[i * count_ + j] = worst;
						apex_[i * count_ + j] = k;
					}
				}
	}

	void append(std::vector<std::array<int, 3>>& triangles) const { append(0, count_ - 1, triangles); }

private:
	void append(int i, int j, std::vector<std::array<int, 3>>& triangles) const {
		const int k = apex_[i * count_ + j];
		if (k < 0)
			return;
		triangles.push_back({polygon_[i], polygon_[k], polygon_[j]});
		append(i, k, triangles);
		append(k, j, triangles);
	}

	const Polygon& polygon_;
	const int count_;
	std::vector<double> best_; // per pair of corners, of what is between them
	std::vector<int> apex_;
};

} // namespace

std::vector<std::array<int, 3>> trianglesOfPolygon(const Eigen::Matrix3Xd& points,
												   const std::vector<std::pair<int, int>>& chords) {
	Polygon all(points.cols());
	for (int corner = 0; corner < static_cast<int>(all.size()); ++corner)
		all[corner] = corner;
	std::vector<Polygon> pieces;
	divide(all, chords, pieces);
	std::vector<std::array<int, 3>> triangles;
	for (const Polygon& piece : pieces)
		BestTriangulation(points, piece).append(triangles);
	return triangles;
}

} // namespace developable::detail
