// SPDX-License-Identifier: GPL-3.0-or-later
// smoothed_patches.cpp: other positions, and the way back.
#include "smoothed_patches.h"

#include "developable/newton/constrained_newton.h"

#include <algorithm>
#include <numeric>

namespace developable::detail {

SmoothedPatches::SmoothedPatches(const GivenPatches& given, const std::vector<double>& limits)
	: given_(given), limits_(limits), assembly_(assemblePatches(given.mesh, {})),
	  smoothed_(withoutDetail(assembly_, *std::min_element(limits.begin(), limits.end()))), smooth_(given) {
	if (!smoothed_)
		return;
	for (int corner = 0; corner < 3 * assembly_.triangleCount(); ++corner)
		smooth_.mesh.positions.col(vertexAt(given.mesh, corner)) =
			smoothed_->originalPositions.col(assembly_.placeAt(corner));
	for (int vertex = 0; vertex < given.mesh.vertexCount(); ++vertex)
		smooth_.origins[vertex] = {vertex, vertex, 0};
	std::iota(smooth_.mesh.face.begin(), smooth_.mesh.face.end(), 0);
	smooth_.vertexTaken.assign(given.mesh.vertexCount(), 0);
}

std::vector<double> SmoothedPatches::limits() const {
	std::vector<double> limits = limits_;
	for (double& limit : limits)
		limit -= roomOfDetail(assembly_, *smoothed_);
	return limits;
}

PlannedSurface SmoothedPatches::carriedBack(const PlannedSurface& planned) const {
	TriangleMesh mesh = planned.mesh;
	std::vector<VertexOrigin> origins = planned.origins;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
		VertexOrigin& origin = origins[vertex];
		mesh.positions.col(vertex) = pointAt(origin, given_.mesh.positions);
		origin.first = given_.origins[origin.first].first;
		origin.second = given_.origins[origin.second].first;
	}
	for (int& face : mesh.face)
		face = given_.mesh.face[face];
	PlannedSurface result{mesh, std::move(origins), CutSurface(assemblePatches(mesh, {}))};
	result.surface.relabel(planned.surface.panels());
	for (int h = 0; h < 3 * mesh.triangleCount(); ++h)
		if (planned.surface.isCut(h) && !result.surface.isCut(h))
			result.surface.setCut(h, true);
	return result;
}

} // namespace developable::detail
