// SPDX-License-Identifier: GPL-3.0-or-later
// taken_back_joins.cpp: last joins first; overlaps half way between their two places.
#include "taken_back_joins.h"

#include "overlap_division.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// The last that had two halves of a size to be seen. \return whether there was any
bool takeBackLastJoin(CutSurface& surface, int panel, JoinHistory& history) {
	constexpr double tooSmall = 0.01; // of the patch: the drawing of seams may lose it
	const int patch = surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()];
	const double least = tooSmall * surface.patchArea(patch);
	while (true) {
		const double whole = surface.area(panel);
		const std::vector<int> triangles = surface.trianglesOf(panel);
		if (!history.takeBack(surface, panel))
			return false;
		for (const int t : triangles)
			if (surface.area(surface.panelOf(t)) > surface.area(panel))
				panel = surface.panelOf(t);
		if (whole - surface.area(panel) >= least)
			return true;
	}
}

} // namespace

int panelBefore(const PlannedSurface& before, const PlannedSurface& now, int panel) {
	std::map<int, int> triangleOfFace;
	for (int t = 0; t < before.mesh.triangleCount(); ++t)
		triangleOfFace[before.mesh.face[t]] = t;
	std::map<int, double> areas;
	for (const int t : now.surface.trianglesOf(panel))
		areas[before.surface.panelOf(triangleOfFace.at(now.mesh.face[t]))] += now.surface.areas()[t];
	return std::max_element(areas.begin(), areas.end(),
							[](const auto& a, const auto& b) { return a.second < b.second; })
		->first;
}

bool takeBackLastJoins(CutSurface& surface, const std::vector<int>& panels, JoinHistory& history) {
	bool any = false;
	for (const int panel : panels)
		any = takeBackLastJoin(surface, panel, history) || any;
	return any;
}

bool divideOverlapping(CutSurface& surface, const std::map<int, std::array<Eigen::Vector3d, 2>>& overlaps,
					   JoinHistory& history) {
	bool any = false;
	for (const auto& [panel, points] : overlaps) {
		history.neverAgain(surface, panel);
		any = divideBetween(surface, panel, points) || any;
	}
	return any;
}

} // namespace developable::detail
