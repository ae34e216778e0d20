// SPDX-License-Identifier: GPL-3.0-or-later
// assemble_patches.cpp: the checks that input has to pass.
#include "assemble_patches.h"

#include "exceptions.h"
#include "grouping.h"
#include "patch_assembler.h"
#include "where.h"

#include <algorithm>
#include <cmath>

namespace developable {

void requireOpenPatches(const PatchAssembly& assembly) {
	const std::vector<int> closed =
		indicesWhere(assembly.patchCount(), [&](int patch) { return assembly.patches[patch].closed(); });
	if (!closed.empty())
		throw ClosedPatch(
			std::to_string(closed.size()) + " of " +
			counted(assembly.patches.size(), "patch is", "patches are") +
			" closed and can't be laid flat: cut it open ('developable cut' on the command line, the filter "
			"Cut into Developable Panels in MeshLab), or give it seams (see the parameter 'patches')." +
			seePatch(assembly, closed.front()));
}

void requireOrientablePatches(const PatchAssembly& assembly) {
	const std::vector<int> oneSided =
		indicesWhere(assembly.patchCount(), [&](int patch) { return !assembly.patches[patch].orientable; });
	if (!oneSided.empty())
		throw NonOrientablePatch(counted(oneSided.size(), "patch has", "patches have") +
								 " only one side, like a Möbius strip: cut it across." +
								 seePatch(assembly, oneSided.front()));
}

void requireFreePlaces(const PatchAssembly& assembly) {
	if (std::find(assembly.placeFixed.begin(), assembly.placeFixed.end(), 0) == assembly.placeFixed.end())
		throw NothingFree("All " + counted(assembly.placeFixed.size(), "vertex is", "vertices are") +
						  " held still, so nothing can move: select fewer vertices, or switch off 'fix "
						  "selected' or 'fix boundary'.");
}

void requireFiniteCoordinates(const TriangleMesh& mesh) {
	const std::vector<int> invalid =
		indicesWhere(mesh.vertexCount(), [&](int vertex) { return !mesh.positions.col(vertex).allFinite(); });
	if (!invalid.empty())
		throw InvalidCoordinate(counted(invalid.size(), "vertex has", "vertices have") +
								" a coordinate that is infinite or not a number: remove " +
								(invalid.size() == 1 ? "it." : "them.") + " See vertex " +
								std::to_string(invalid.front()) + ".");
}

namespace {

void requireAreas(const PatchAssembly& assembly) {
	const std::vector<int> flat = zeroAreaTriangles(assembly, assembly.originalPositions);
	if (!flat.empty())
		throw DegenerateTriangle(counted(flat.size(), "face has", "faces have") +
								 " no area: remove zero-area faces, or merge close vertices, first." +
								 seeFace(assembly, flat.front()));
}

} // namespace

PatchAssembly assemblePatches(const TriangleMesh& mesh, const PatchOptions& options) {
	if (mesh.triangleCount() == 0)
		throw EmptyMesh("The mesh has no faces: open a mesh with faces, or build them first.");
	if (!(options.weldDistance >= 0) || std::isinf(options.weldDistance))
		throw InvalidParameter("The weld distance is " + std::to_string(options.weldDistance) +
							   ": choose 0 or a positive length.");
	requireFiniteCoordinates(mesh);
	PatchAssembly assembly = detail::PatchAssembler(mesh, options).assemble();
	requireAreas(assembly);
	return assembly;
}

} // namespace developable
