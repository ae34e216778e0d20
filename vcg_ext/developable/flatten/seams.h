// SPDX-License-Identifier: GPL-3.0-or-later
// seams.h: which boundary curve of a pattern is sewn to which.
#pragma once

#include "flat_patterns.h"

namespace developable {

/// The seams of patterns: between pieces, of a piece with itself, and along cuts.
std::vector<Seam> findSeams(const PatchAssembly& assembly, const FlatPatterns& patterns);

} // namespace developable
