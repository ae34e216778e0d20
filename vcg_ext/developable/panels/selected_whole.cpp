// SPDX-License-Identifier: GPL-3.0-or-later
// selected_whole.cpp: one label for each connected part.
#include "selected_whole.h"

#include <algorithm>
#include <map>

namespace developable::detail {

std::vector<char> keptTriangles(const PlannedSurface& planned, const CutOptions& options) {
	return options.keepSelected ? planned.mesh.triangleSelected : std::vector<char>();
}

std::vector<int> withSelectedWhole(const PlannedSurface& planned, const CutOptions& options,
								   std::vector<int> labels) {
	if (!options.keepSelected)
		return labels;
	const std::vector<char>& selected = planned.mesh.triangleSelected;
	const PatchAssembly& assembly = planned.surface.assembly();
	DisjointSets connected(assembly.triangleCount());
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int other = assembly.across(h);
		if (other >= 0 && selected[triangleOf(h)] && selected[triangleOf(other)])
			connected.unite(triangleOf(h), triangleOf(other));
	}
	std::map<int, std::map<int, double>> areas; // by part and label
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if (selected[t])
			areas[connected.find(t)][labels[t]] += planned.surface.areas()[t];
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if (selected[t]) {
			const auto& ofPart = areas[connected.find(t)];
			labels[t] = std::max_element(ofPart.begin(), ofPart.end(), [](const auto& a, const auto& b) {
							return a.second < b.second;
						})->first;
		}
	return labels;
}

} // namespace developable::detail
