// SPDX-License-Identifier: GPL-3.0-or-later
// where.h: where a user finds the first of the elements that a refusal counts.
#pragma once

#include "patch_assembly.h"

#include <string>

namespace developable {

/// " See face 12, at (0.5, 1, 0).": the face's number in the mesh, and its middle in the mesh's unit.
std::string seeFace(const TriangleMesh& mesh, int triangle);
std::string seeFace(const PatchAssembly& assembly, int triangle);

/// The same of the first face of a patch.
std::string seePatch(const PatchAssembly& assembly, int patch);

} // namespace developable
