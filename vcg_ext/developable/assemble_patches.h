// SPDX-License-Identifier: GPL-3.0-or-later
// assemble_patches.h: from a mesh to the patches it is made of, with every check that input has to pass.
#pragma once

#include "detail/patch_assembler.h"

#include <cmath>

namespace developable {

/// \throws ClosedPatch  when a patch has no boundary; says how many there are
inline void requireOpenPatches(const PatchAssembly& assembly) {
	const auto closed = std::count_if(assembly.patches.begin(), assembly.patches.end(),
									  [](const Patch& patch) { return patch.closed(); });
	if (closed > 0)
		throw ClosedPatch(
			std::to_string(closed) + " of " +
			detail::counted(assembly.patches.size(), "patch is", "patches are") +
			" closed and can't be laid flat: cut it open, or give it seams (see the parameter 'patches').");
}

/// \throws NonOrientablePatch  when a patch has one side only; says how many there are
inline void requireOrientablePatches(const PatchAssembly& assembly) {
	const auto oneSided = std::count_if(assembly.patches.begin(), assembly.patches.end(),
										[](const Patch& patch) { return !patch.orientable; });
	if (oneSided > 0)
		throw NonOrientablePatch(detail::counted(oneSided, "patch has", "patches have") +
								 " only one side, like a Möbius strip: cut it across.");
}

/// \throws NothingFree  when every vertex is held still
inline void requireFreePlaces(const PatchAssembly& assembly) {
	if (std::find(assembly.placeFixed.begin(), assembly.placeFixed.end(), 0) == assembly.placeFixed.end())
		throw NothingFree("All " + detail::counted(assembly.placeFixed.size(), "vertex is", "vertices are") +
						  " held still, so nothing can move: select fewer vertices, or switch off 'fix "
						  "selected' or 'fix boundary'.");
}

namespace detail {

inline void requireFiniteCoordinates(const TriangleMesh& mesh) {
	std::size_t invalid = 0;
	for (const auto& position : mesh.positions.colwise())
		invalid += !position.allFinite();
	if (invalid > 0)
		throw InvalidCoordinate(counted(invalid, "vertex has", "vertices have") +
								" a coordinate that is infinite or not a number: remove " +
								(invalid == 1 ? "it." : "them."));
}

inline void requireAreas(const PatchAssembly& assembly) {
	const int flat = countZeroAreaTriangles(assembly, assembly.originalPositions);
	if (flat > 0)
		throw DegenerateTriangle(counted(flat, "face has", "faces have") +
								 " no area: remove zero-area faces, or merge close vertices, first.");
}

} // namespace detail

/// Takes a mesh apart into patches, vertex copies and linked vertex sets.
/// \throws EmptyMesh           when there is no face, or none is selected and only those were asked for
/// \throws InvalidCoordinate   when a coordinate is not finite
/// \throws InvalidParameter    when the weld distance is negative or not a number
/// \throws DegenerateTriangle  when a triangle has no area, or would lose it to the weld distance
inline PatchAssembly assemblePatches(const TriangleMesh& mesh, const PatchOptions& options) {
	if (mesh.triangleCount() == 0)
		throw EmptyMesh("The mesh has no faces: open a mesh with faces, or build them first.");
	if (!(options.weldDistance >= 0) || std::isinf(options.weldDistance))
		throw InvalidParameter("The weld distance is " + std::to_string(options.weldDistance) +
							   ": choose 0 or a positive length.");
	detail::requireFiniteCoordinates(mesh);
	PatchAssembly assembly = detail::PatchAssembler(mesh, options).assemble();
	detail::requireAreas(assembly);
	return assembly;
}

} // namespace developable
