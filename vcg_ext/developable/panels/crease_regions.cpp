// SPDX-License-Identifier: GPL-3.0-or-later
// crease_regions.cpp: triangles that no crease keeps apart, and what is left inside.
#include "crease_regions.h"

#include <cmath>

namespace developable::detail {

std::vector<int> regionsBetween(const SharpFeatures& features, const CutSurface& surface,
								const std::vector<int>& triangles) {
	DisjointSets regions(surface.assembly().triangleCount());
	for (const int t : triangles)
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (surface.across(h) >= 0 && features.edges[h] != SharpFeatures::Alone)
				regions.unite(t, triangleOf(surface.across(h)));
	std::vector<int> labels;
	labels.reserve(triangles.size());
	for (const int t : triangles)
		labels.push_back(regions.find(t));
	return labels;
}

bool isDevelopable(const CutSurface& surface) {
	constexpr double roundings = 1e-3; // rad: of coordinates with few digits
	const PatchAssembly& assembly = surface.assembly();
	std::vector<char> inside = assembly.copyInterior;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
		if (surface.isCut(h))
			inside[surface.startOf(h)] = inside[surface.endOf(h)] = 0;
	const Eigen::VectorXd defects = angleDefects(assembly, surface.positions());
	for (int copy = 0; copy < defects.size(); ++copy)
		if (inside[copy] && !surface.isSharpPoint(copy) && std::abs(defects[copy]) > roundings)
			return false;
	return true;
}

bool liesOnCrease(const SeamChain& chain, const CutSurface& surface, const SharpFeatures& features) {
	double length = 0;
	for (const int h : chain.halfEdges)
		if (features.edges[h] == SharpFeatures::Alone)
			length += surface.length(h);
	return length > chain.length / 2;
}

} // namespace developable::detail
