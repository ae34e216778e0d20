// SPDX-License-Identifier: GPL-3.0-or-later
// cut_sides.cpp: fronts that grow from both sides of every slit and dart.
#include "cut_sides.h"

#include "seam_chains.h"

#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace developable::detail {

namespace {

/// Per half edge the side of a slit or dart that it is, from 0; else -1.
std::vector<int> sidesOfSlits(const CutSurface& surface) {
	const PatchAssembly& assembly = surface.assembly();
	std::vector<int> sides(3 * assembly.triangleCount(), -1);
	int count = 0;
	for (const SeamChain& chain : seamChains(surface)) {
		if (!chain.within())
			continue;
		int copy = chain.ends[0];
		for (const int h : chain.halfEdges) {
			const bool forward = surface.startOf(h) == copy;
			const bool left = forward != (assembly.triangleReversed[triangleOf(h)] != 0);
			sides[h] = count + left;
			sides[assembly.across(h)] = count + !left;
			copy = forward ? surface.endOf(h) : surface.startOf(h);
		}
		count += 2;
	}
	return sides;
}

/// Where a triangle is at two sides, the first round their common vertex: then of those that meet there no
/// two get the same.
int sideOf(const std::vector<int>& sides, int triangle) {
	int side = -1;
	for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
		if (sides[h] >= 0 && (side < 0 || sides[nextCorner(h)] >= 0))
			side = sides[h];
	return side;
}

/// The nearest side within the panel, per triangle; -1 where it has none.
std::vector<int> nearestSides(const CutSurface& surface) {
	const std::vector<int> sides = sidesOfSlits(surface);
	std::vector<int> nearest(surface.assembly().triangleCount(), -1);
	using Step = std::pair<double, std::pair<int, int>>; // length so far, triangle and side
	std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
	for (int t = 0; t < surface.assembly().triangleCount(); ++t)
		if (const int side = sideOf(sides, t); side >= 0)
			steps.push({0, {t, side}});
	while (!steps.empty()) {
		const auto [length, step] = steps.top();
		const auto [triangle, side] = step;
		steps.pop();
		if (nearest[triangle] >= 0)
			continue;
		nearest[triangle] = side;
		for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
			if (const int across = surface.across(h); across >= 0 && nearest[triangleOf(across)] < 0) {
				const int next = triangleOf(across);
				const double distance = (surface.barycentre(next) - surface.barycentre(triangle)).norm();
				steps.push({length + distance, {next, side}});
			}
	}
	return nearest;
}

} // namespace

std::vector<int> cutSides(const CutSurface& surface) {
	std::map<std::pair<int, int>, int> numbers;
	std::vector<int> labels = nearestSides(surface);
	for (std::size_t t = 0; t < labels.size(); ++t)
		labels[t] = numbers
						.emplace(std::make_pair(surface.panelOf(static_cast<int>(t)), labels[t]),
								 static_cast<int>(numbers.size()))
						.first->second;
	return labels;
}

} // namespace developable::detail
