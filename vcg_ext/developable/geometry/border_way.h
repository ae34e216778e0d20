// SPDX-License-Identifier: GPL-3.0-or-later
// border_way.h: the shorter way along a closed border.
#pragma once

#include <vector>

namespace developable::detail {

/// A part of a closed border, edge by edge from a first one on.
struct BorderWay {
	int first = 0, count = 0;
	double length = 0;
};

/// From one of two edges to the other, with both.
/// \param begins  where each edge of the border begins along it, and where the last one ends, length
BorderWay shorterWay(const std::vector<double>& begins, int a, int b);

} // namespace developable::detail
