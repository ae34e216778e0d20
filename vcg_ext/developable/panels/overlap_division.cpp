// SPDX-License-Identifier: GPL-3.0-or-later
// overlap_division.cpp: two fronts that grow over the triangles of a panel.
#include "overlap_division.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <tuple>

namespace developable::detail {

namespace {

int nearestTriangle(const CutSurface& surface, int panel, const Eigen::Vector3d& point) {
	const std::vector<int>& triangles = surface.trianglesOf(panel);
	return *std::min_element(triangles.begin(), triangles.end(), [&](int a, int b) {
		return (surface.barycentre(a) - point).squaredNorm() < (surface.barycentre(b) - point).squaredNorm();
	});
}

} // namespace

bool divideBetween(CutSurface& surface, int panel, const std::array<Eigen::Vector3d, 2>& points) {
	using Step = std::tuple<double, int, int>; // length so far, triangle, front
	std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
	for (const int front : {0, 1})
		steps.emplace(0, nearestTriangle(surface, panel, points[front]), front);
	std::map<int, int> frontAt;
	while (!steps.empty()) {
		const auto [length, triangle, front] = steps.top();
		steps.pop();
		if (!frontAt.emplace(triangle, front).second)
			continue;
		for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
			if (surface.across(h) >= 0) {
				const int next = triangleOf(surface.across(h));
				steps.emplace(length + (surface.barycentre(next) - surface.barycentre(triangle)).norm(), next,
							  front);
			}
	}
	std::vector<int> labels;
	bool both = false;
	for (const int triangle : surface.trianglesOf(panel)) {
		labels.push_back(frontAt.at(triangle));
		both = both || labels.back() != labels.front();
	}
	if (both)
		surface.divide(panel, labels);
	return both;
}

} // namespace developable::detail
