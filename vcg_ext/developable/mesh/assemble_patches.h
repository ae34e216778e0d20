// SPDX-License-Identifier: GPL-3.0-or-later
// assemble_patches.h: from a mesh to the patches it is made of, with every check that input has to pass.
#pragma once

#include "options.h"
#include "patch_assembly.h"

namespace developable {

/// \throws ClosedPatch  when a patch has no boundary; says how many there are, and where the first is
void requireOpenPatches(const PatchAssembly& assembly);

/// \throws NonOrientablePatch  when a patch has one side only; says how many there are, and where the first
/// is
void requireOrientablePatches(const PatchAssembly& assembly);

/// \throws NothingFree  when every vertex is held still
void requireFreePlaces(const PatchAssembly& assembly);

/// \throws InvalidCoordinate  when a coordinate is not finite; says how many vertices have one, and which is
/// the first
void requireFiniteCoordinates(const TriangleMesh& mesh);

/// Takes a mesh apart into patches, vertex copies and linked vertex sets.
/// \throws EmptyMesh           when there is no face, or none is selected and only those were asked for
/// \throws InvalidCoordinate   when a coordinate is not finite
/// \throws InvalidParameter    when the weld distance is negative or not a number
/// \throws DegenerateTriangle  when a triangle has no area, or would lose it to the weld distance
PatchAssembly assemblePatches(const TriangleMesh& mesh, const PatchOptions& options);

} // namespace developable
