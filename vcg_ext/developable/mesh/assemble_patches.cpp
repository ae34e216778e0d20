// SPDX-License-Identifier: GPL-3.0-or-later
// assemble_patches.cpp: the checks that input has to pass.
#include "assemble_patches.h"

#include "exceptions.h"
#include "patch_assembler.h"

#include <algorithm>
#include <cmath>

namespace developable {

void requireOpenPatches(const PatchAssembly& assembly) {
	const auto closed = std::count_if(assembly.patches.begin(), assembly.patches.end(),
									  [](const Patch& patch) { return patch.closed(); });
	if (closed > 0)
		throw ClosedPatch(
			std::to_string(closed) + " of " + counted(assembly.patches.size(), "patch is", "patches are") +
			" closed and can't be laid flat: cut it open ('developable cut' on the command line, the filter "
			"Cut into Developable Panels in MeshLab), or give it seams (see the parameter 'patches').");
}

void requireOrientablePatches(const PatchAssembly& assembly) {
	const auto oneSided = std::count_if(assembly.patches.begin(), assembly.patches.end(),
										[](const Patch& patch) { return !patch.orientable; });
	if (oneSided > 0)
		throw NonOrientablePatch(counted(oneSided, "patch has", "patches have") +
								 " only one side, like a Möbius strip: cut it across.");
}

void requireFreePlaces(const PatchAssembly& assembly) {
	if (std::find(assembly.placeFixed.begin(), assembly.placeFixed.end(), 0) == assembly.placeFixed.end())
		throw NothingFree("All " + counted(assembly.placeFixed.size(), "vertex is", "vertices are") +
						  " held still, so nothing can move: select fewer vertices, or switch off 'fix "
						  "selected' or 'fix boundary'.");
}

void requireFiniteCoordinates(const TriangleMesh& mesh) {
	std::size_t invalid = 0;
	for (const auto& position : mesh.positions.colwise())
		invalid += !position.allFinite();
	if (invalid > 0)
		throw InvalidCoordinate(counted(invalid, "vertex has", "vertices have") +
								" a coordinate that is infinite or not a number: remove " +
								(invalid == 1 ? "it." : "them."));
}

namespace {

void requireAreas(const PatchAssembly& assembly) {
	const int flat = countZeroAreaTriangles(assembly, assembly.originalPositions);
	if (flat > 0)
		throw DegenerateTriangle(counted(flat, "face has", "faces have") +
								 " no area: remove zero-area faces, or merge close vertices, first.");
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
