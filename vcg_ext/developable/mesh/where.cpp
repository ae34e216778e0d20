// SPDX-License-Identifier: GPL-3.0-or-later
// where.cpp: numbers and coordinates as hosts show them.
#include "where.h"

#include "length_unit.h"

#include <algorithm>
#include <cstdio>

namespace developable {

namespace {

std::string see(int face, const Positions& corners, int lengthExponent) {
	const Eigen::Vector3d middle = inMeshUnits(lengthExponent, corners / 3).rowwise().sum();
	char text[128];
	std::snprintf(text, sizeof text, " See face %d, at (%.6g, %.6g, %.6g).", face, middle[0], middle[1],
				  middle[2]);
	return text;
}

} // namespace

std::string seeFace(const TriangleMesh& mesh, int triangle) {
	return see(mesh.face[triangle], mesh.positions(Eigen::all, mesh.triangles.col(triangle)),
			   mesh.lengthExponent);
}

std::string seeFace(const PatchAssembly& assembly, int triangle) {
	return see(assembly.faceOfTriangle[triangle],
			   assembly.originalPositions(Eigen::all, assembly.trianglePlaces.col(triangle)),
			   assembly.lengthExponent);
}

std::string seePatch(const PatchAssembly& assembly, int patch) {
	const auto first = std::find(assembly.patchOfTriangle.begin(), assembly.patchOfTriangle.end(), patch);
	return seeFace(assembly, static_cast<int>(first - assembly.patchOfTriangle.begin()));
}

} // namespace developable
