// SPDX-License-Identifier: GPL-3.0-or-later
// border_fans.cpp: fans of triangles at border vertices, and the angle between their first and last edge.
#include "border_fans.h"

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace developable {

namespace {

constexpr double nearlyFull = 1.5 * pi; ///< strains do not turn what is less into a full turn
constexpr double margin = 1e-3;         ///< rad: two sides of a slit that touch would count as an overlap

double direction(const Eigen::Vector2d& edge) {
	return std::atan2(edge[1], edge[0]);
}

/// Between two edges, counterclockwise, from π to 3π.
double turn(const Eigen::Vector2d& first, const Eigen::Vector2d& last) {
	const double angle = std::remainder(direction(last) - direction(first), 2 * pi); // −π to π
	return angle + 2 * pi;
}

/// The derivatives of an edge's direction by its second end; by the first they are the opposite.
Eigen::Vector2d turning(const Eigen::Vector2d& edge) {
	return Eigen::Vector2d(-edge[1], edge[0]) / edge.squaredNorm();
}

} // namespace

BorderFans::BorderFans(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& weights,
					   const Eigen::Matrix2Xd& flat) {
	std::map<std::pair<int, int>, int> halfEdges; // the number of each direction
	Eigen::VectorXd angles = Eigen::VectorXd::Zero(flat.cols()), weightAt = angles;
	for (int h = 0; h < 3 * static_cast<int>(triangles.cols()); ++h) {
		const int vertex = triangles.data()[h], next = triangles.data()[nextCorner(h)],
				  other = triangles.data()[nextCorner(nextCorner(h))];
		++halfEdges[{vertex, next}];
		angles[vertex] += std::abs(std::remainder(direction(flat.col(other) - flat.col(vertex)) -
													  direction(flat.col(next) - flat.col(vertex)),
												  2 * pi));
		weightAt[vertex] += weights[triangleOf(h)];
	}
	std::vector<int> before(flat.cols(), -1), after(flat.cols(), -1); // along the border
	for (const auto& [ends, count] : halfEdges)
		if (halfEdges.count({ends.second, ends.first}) == 0) {
			after[ends.first] = ends.second;
			before[ends.second] = ends.first;
		}
	for (int vertex = 0; vertex < static_cast<int>(flat.cols()); ++vertex)
		if (before[vertex] >= 0 && after[vertex] >= 0 && angles[vertex] > nearlyFull)
			fans_.push_back({vertex, after[vertex], before[vertex], weightAt[vertex]});
}

double BorderFans::value(const RoundedPenalty& edge, const Eigen::Matrix2Xd& flat) const {
	double sum = 0;
	for (const Fan& fan : fans_) {
		const double angle =
			turn(flat.col(fan.first) - flat.col(fan.vertex), flat.col(fan.last) - flat.col(fan.vertex));
		sum += fan.weight * edge.value(angle - 2 * pi + margin);
	}
	return sum;
}

std::vector<BorderFans::EdgeElement> BorderFans::elements(const RoundedPenalty& edge,
														  const Eigen::Matrix2Xd& flat) const {
	std::vector<EdgeElement> result;
	result.reserve(2 * fans_.size());
	for (const Fan& fan : fans_) {
		const Eigen::Vector2d first = flat.col(fan.first) - flat.col(fan.vertex),
							  last = flat.col(fan.last) - flat.col(fan.vertex);
		const double c = turn(first, last) - 2 * pi + margin;
		const auto add = [&](int end, const Eigen::Vector2d& byEnd) {
			Eigen::Vector4d row;
			row << -byEnd, byEnd;
			// (a + b)² ≤ 2 a² + 2 b² for the shares of both edges.
			result.push_back({{fan.vertex, end},
							  fan.weight * edge.first(c) * row,
							  2 * fan.weight * edge.second(c) * row * row.transpose()});
		};
		add(fan.last, turning(last));
		add(fan.first, -turning(first));
	}
	return result;
}

double BorderFans::excess(const Eigen::Matrix2Xd& flat) const {
	double greatest = 0;
	for (const Fan& fan : fans_)
		greatest = std::max(greatest, turn(flat.col(fan.first) - flat.col(fan.vertex),
										   flat.col(fan.last) - flat.col(fan.vertex)) -
										  2 * pi);
	return greatest;
}

} // namespace developable
