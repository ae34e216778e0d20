// SPDX-License-Identifier: GPL-3.0-or-later
// border_parts.h: parts of the border of a panel that is laid flat.
#pragma once

#include "developable/flatten/flatten.h"

#include <vector>

namespace developable::detail {

struct BorderPart {
	std::vector<int> halfEdges; ///< in order
	double share = 1;           ///< of the border's length
};

/// Of each crossing of a piece with itself the shorter way along its border from one of the two half edges
/// to the other, with both; ways that are parts of others are left out. Where the two are of two borders, or
/// the border touches itself, it is the whole border, and no half edges are given.
std::vector<BorderPart> notchesOf(const FlatPatterns& patterns, const FlatPiece& piece);

/// That with the largest share of the border.
/// \param notches  one or more
const BorderPart& largestNotch(const std::vector<BorderPart>& notches);

/// The longest stretch of a piece's border that lies upon the piece itself, length.
/// \param piece  one without cuts that crosses itself
double coveredStretch(const FlatPatterns& patterns, const FlatPiece& piece);

} // namespace developable::detail
