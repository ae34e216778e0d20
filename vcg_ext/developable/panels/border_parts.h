// SPDX-License-Identifier: GPL-3.0-or-later
// border_parts.h: parts of the border of a panel that is laid flat.
#pragma once

#include "developable/flatten/flatten.h"

#include <array>
#include <vector>

namespace developable::detail {

struct BorderPart {
	std::vector<int> halfEdges; ///< in order
	double share = 0;           ///< of the border's length
};

/// From one half edge of a piece's border to another the way that is shorter, with both; none where they are
/// of two borders, or the border touches itself.
BorderPart shorterBorderPart(const FlatPatterns& patterns, const std::array<int, 2>& ends);

} // namespace developable::detail
