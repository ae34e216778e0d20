// SPDX-License-Identifier: GPL-3.0-or-later
// partial_assembly.cpp: takes triangles out of an assembly.
#include "partial_assembly.h"

#include "assemble_patches.h"

#include <numeric>

namespace developable {

PartialAssembly partialAssembly(const PatchAssembly& whole, const Eigen::Matrix3Xi& triangles) {
	std::vector<int> vertexOfCopy(whole.copyCount(), -1), placeOfVertex;
	TriangleMesh mesh;
	mesh.triangles.resize(3, triangles.cols());
	for (Eigen::Index corner = 0; corner < triangles.size(); ++corner) {
		const int copy = triangles.data()[corner];
		if (vertexOfCopy[copy] < 0) {
			vertexOfCopy[copy] = static_cast<int>(placeOfVertex.size());
			placeOfVertex.push_back(whole.placeOfCopy[copy]);
		}
		mesh.triangles.data()[corner] = vertexOfCopy[copy];
	}
	mesh.positions = whole.originalPositions(Eigen::all, placeOfVertex);
	for (const int place : placeOfVertex)
		mesh.vertexSelected.push_back(whole.placeFixed[place]);
	mesh.triangleSelected.assign(triangles.cols(), 0);
	mesh.face.resize(triangles.cols());
	std::iota(mesh.face.begin(), mesh.face.end(), 0);
	mesh.leastHeightRatio = whole.leastHeightRatio;
	mesh.lengthExponent = whole.lengthExponent;
	PatchOptions options;
	options.fixSelected = true;
	PartialAssembly result{assemblePatches(mesh, options), {}, {}};
	result.wholePlace.resize(result.assembly.placeCount());
	for (std::size_t vertex = 0; vertex < placeOfVertex.size(); ++vertex)
		result.wholePlace[result.assembly.placeOfVertex[vertex]] = placeOfVertex[vertex];
	const PatchAssembly& part = result.assembly;
	result.wholePatch.resize(part.patchCount());
	for (int t = 0; t < part.triangleCount(); ++t)
		result.wholePatch[part.patchOfTriangle[t]] = whole.patchOfCopy[triangles(0, part.faceOfTriangle[t])];
	return result;
}

} // namespace developable
