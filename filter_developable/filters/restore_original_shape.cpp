// SPDX-License-Identifier: GPL-3.0-or-later
// restore_original_shape.cpp: the filter Restore Original Shape, the way back from an optimisation.
#include "../layer.h"
#include "filters.h"

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <vcg/complex/allocate.h>

namespace developable::plugin {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;
using Point = vcg::Point3<host::Scalar>;

bool isFinite(const Point& point) {
	return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

/// Where the vertices were, to the last bit of the host's numbers.
/// \throws MissingAttribute  when the mesh does not say so, or not with numbers
CMeshO::PerVertexAttributeHandle<Point> originalPositions(CMeshO& mesh) {
	auto original = Allocator::FindPerVertexAttribute<Point>(mesh, "original_position");
	if (!Allocator::IsValidHandle(mesh, original))
		throw MissingAttribute(
			"The layer has no attribute 'original_position' to go back to: Global and Local Developability "
			"leave one. Files do not keep it; File, Reload reads the shape that a file has.");
	const std::vector<int> invalid = indicesWhere(int(mesh.vert.size()), [&](int vertex) {
		return !mesh.vert[vertex].IsD() && !isFinite(original[vertex]);
	});
	if (!invalid.empty())
		throw MissingAttribute(counted(invalid.size(), "vertex has", "vertices have") +
							   " an 'original_position' that is not a number: compute it anew. See vertex " +
							   std::to_string(invalid.front()) + ".");
	return original;
}

Results runRestore(FilterCall& call) {
	CMeshO& mesh = call.layer.mesh();
	if (mesh.vn == 0)
		throw EmptyMesh("The mesh has no vertices to move back.");
	auto original = originalPositions(mesh);
	int moved = 0;
	double farthest = 0;
	for (std::size_t vertex = 0; vertex < mesh.vert.size(); ++vertex) {
		if (mesh.vert[vertex].IsD() || mesh.vert[vertex].cP() == original[vertex])
			continue;
		++moved;
		const auto here = vcg::Point3d::Construct(mesh.vert[vertex].cP());
		farthest = std::max(farthest, vcg::Distance(here, vcg::Point3d::Construct(original[vertex])));
		mesh.vert[vertex].P() = original[vertex];
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
	filter.run = runRestore;
	return filter;
}

} // namespace developable::plugin
