// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layout.h: how patterns lie: each piece upright, one beside the other.
#pragma once

#include "flat_patterns.h"

namespace developable::detail {

/// Per piece the ends of its longest seam, or of its longest side between corners where it has no seams; -1
/// where it has neither.
/// \param outerLoops  per piece the vertices round it
std::vector<std::array<int, 2>> longestSides(const PatchAssembly& assembly, const FlatPatterns& patterns,
											 const std::vector<std::vector<int>>& outerLoops);

/// Turns every piece so that its longest side stands upright.
/// \param model        3 x places
/// \param firstVertex  pieces + 1, where the vertices of each begin
void standUpright(const Positions& model, FlatPatterns& patterns,
				  const std::vector<std::array<int, 2>>& longestSides, const std::vector<int>& firstVertex);

/// Lays pieces in rows, none in another's box.
/// \param firstVertex  pieces + 1, where the vertices of each begin
/// \param gap          between boxes, length; negative: 2 % of the diagonal of the largest box
void laySideBySide(FlatPatterns& patterns, const std::vector<int>& firstVertex, double gap);

} // namespace developable::detail
