// SPDX-License-Identifier: GPL-3.0-or-later
// restore_original_shape.cpp: the filter Restore Original Shape, the way back from an optimisation.
#include "../layer.h"
#include "../vertex_data.h"
#include "filters.h"

#include <algorithm>
#include <cmath>

namespace developable::plugin {

namespace {

/// Where the vertices were.
/// \throws MissingAttribute  when the mesh does not say so, or not with numbers
Positions originalPositions(CMeshO& mesh) {
	const std::optional<Positions> original = readPointAttribute(mesh, "original_position");
	if (!original)
		throw MissingAttribute(
			"The layer has no attribute 'original_position' to go back to: Global and Local Developability "
			"leave one. Files do not keep it; File, Reload reads the shape that a file has.");
	std::size_t invalid = 0;
	for (std::size_t vertex = 0; vertex < mesh.vert.size(); ++vertex)
		invalid += !mesh.vert[vertex].IsD() && !original->col(Eigen::Index(vertex)).allFinite();
	if (invalid > 0)
		throw MissingAttribute(counted(invalid, "vertex has", "vertices have") +
							   " an 'original_position' that is not a number: compute it anew.");
	return *original;
}

Results run(FilterCall& call) {
	CMeshO& mesh = call.layer.mesh();
	if (mesh.vn == 0)
		throw EmptyMesh("The mesh has no vertices to move back.");
	const Positions original = originalPositions(mesh);
	int moved = 0;
	double farthest = 0;
	for (std::size_t vertex = 0; vertex < mesh.vert.size(); ++vertex) {
		if (mesh.vert[vertex].IsD())
			continue;
		double squaredDistance = 0;
		for (int axis = 0; axis < 3; ++axis) {
			host::Scalar& coordinate = mesh.vert[vertex].P()[axis];
			const double back = original(axis, Eigen::Index(vertex));
			squaredDistance += std::pow(back - double(coordinate), 2);
			coordinate = static_cast<host::Scalar>(back);
		}
		moved += squaredDistance > 0;
		farthest = std::max(farthest, std::sqrt(squaredDistance));
	}
	call.layer.positionsChanged();
	call.verdict(counted(std::size_t(moved), "vertex", "vertices") +
				 " moved back to where the last optimisation found them, by at most " +
				 formatted(farthest, 4) + " units of the mesh");
	return {{"moved_vertices", moved, ""}, {"max_displacement", farthest, ""}};
}

} // namespace

FilterDescription originalShapeRestoring() {
	FilterDescription filter;
	filter.name = "Restore Original Shape";
	filter.pythonName = "apply_coord_restore_original_shape";
	filter.shortName = "restore";
	filter.filterClass = FilterClass::Smoothing;
	filter.change = Change::Positions;
	filter.help =
		"The way back from Global and Local Developability: moves every vertex of the layer to where the last of "
		"them found it. MeshLab itself cannot undo a filter.<br><br>"
		"Only places are restored. Quality and colours keep the map that was shown, and what other filters have "
		"done to the vertices' places since then is lost. The places are in the attribute "
		"<i>original_position</i>, which ends with the session: files do not keep it.";
	filter.run = run;
	return filter;
}

} // namespace developable::plugin
