// SPDX-License-Identifier: GPL-3.0-or-later
// patch_assembly.cpp: lengths and areas of an assembly.
#include "patch_assembly.h"

#include "grouping.h"

namespace developable {

int PatchAssembly::interiorCopyCount() const {
	return static_cast<int>(std::count(copyInterior.begin(), copyInterior.end(), 1));
}

int PatchAssembly::assemblingPlaceCount() const {
	return static_cast<int>(std::count(placeAssembling.begin(), placeAssembling.end(), 1));
}

bool holdsPlaces(const PatchAssembly& assembly) {
	return std::count(assembly.placeFixed.begin(), assembly.placeFixed.end(), 1) > 0;
}

Eigen::VectorXd edgeLengths(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd lengths(assembly.edgeCount());
	for (int edge = 0; edge < assembly.edgeCount(); ++edge)
		lengths[edge] =
			(positions.col(assembly.edgePlaces(1, edge)) - positions.col(assembly.edgePlaces(0, edge)))
				.norm();
	return lengths;
}

double meanEdgeLength(const PatchAssembly& assembly) {
	return edgeLengths(assembly, assembly.originalPositions).mean();
}

std::vector<int> zeroAreaTriangles(const PatchAssembly& assembly, const Positions& positions) {
	return indicesWhere(assembly.triangleCount(), [&](int t) {
		const auto places = assembly.trianglePlaces.col(t);
		const Eigen::Vector3d a = positions.col(places[1]) - positions.col(places[0]);
		const Eigen::Vector3d b = positions.col(places[2]) - positions.col(places[0]);
		const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
		// Twice the area is height times longest edge.
		return !(a.cross(b).norm() >= assembly.leastHeightRatio * longest) || longest == 0;
	});
}

} // namespace developable
