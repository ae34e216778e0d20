// SPDX-License-Identifier: GPL-3.0-or-later
// assembly_parts.h: an assembly taken apart where nothing is shared.
#pragma once

#include "patch_assembly.h"

namespace developable {

/// A part of an assembly, the whole: patches that share places, be it in a row. What moves in one part has
/// no bearing on another.
struct AssemblyPart {
	/// Places, copies, triangles and patches are in the same order as in the whole, so that a part is the
	/// same to the last bit whatever company it is in. It has no mesh vertices (placeOfVertex is empty).
	PatchAssembly assembly;
	std::vector<int> wholePlace; ///< per place, which one of the whole it is
	std::vector<int> wholePatch; ///< per patch
};

/// All parts, in the order of their first patches.
std::vector<AssemblyPart> partsOf(const PatchAssembly& whole);

} // namespace developable
