// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layout.h: how patterns lie: each piece upright, one beside the other.
#pragma once

#include "flat_patterns.h"

namespace developable::detail {

/// Turns every piece so that its longest seam, or its longest side when it has no seams, stands upright.
/// \param model        3 x places
/// \param outerLoops   per piece the vertices round it
/// \param firstVertex  pieces + 1, where the vertices of each begin
void standUpright(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns,
				  const std::vector<std::vector<int>>& outerLoops, const std::vector<int>& firstVertex);

/// Lays pieces in rows, none in another's box.
/// \param firstVertex  pieces + 1, where the vertices of each begin
/// \param gap          between boxes, length; negative: 2 % of the diagonal of the largest box
void laySideBySide(FlatPatterns& patterns, const std::vector<int>& firstVertex, double gap);

} // namespace developable::detail
