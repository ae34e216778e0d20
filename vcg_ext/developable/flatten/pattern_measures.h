// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_measures.h: what there is to measure of patterns: strains, energies, seams, overlaps, flips.
#pragma once

#include "flat_patterns.h"

namespace developable {

/// Measures patterns from their coordinates, anew when these were rounded: fills the maps, the seams, the
/// report, and what of every piece can be measured.
/// \param model  3 x places
void measurePatterns(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns);

} // namespace developable
