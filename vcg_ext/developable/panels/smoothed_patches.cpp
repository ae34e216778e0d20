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
	numberByThemselves(smooth_);
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
	std::vector<int> same(3 * mesh.triangleCount());
	std::iota(same.begin(), same.end(), 0);
	return withPanelsOf(planned.surface, std::move(mesh), std::move(origins), same);
}

} // namespace developable::detail
