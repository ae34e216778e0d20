// SPDX-License-Identifier: GPL-3.0-or-later
// colour_map.h: the colours that a map of values is shown in.
#pragma once

#include <Eigen/Core>
#include <vcg/space/color4.h>
#include <vector>

namespace developable::plugin {

/// The values that the first and the last colour stand for.
struct ColourRange {
	double low = 0;
	double high = 0;
};

/// The range that shows all values: from 0 for one-sided maps, symmetric about 0 for signed ones. Where all
/// values are 0 it reaches to 1.
ColourRange colourRange(const Eigen::VectorXd& values, bool isSigned);

/// One colour per value: blue for the least, green in the middle, red for the largest.
std::vector<vcg::Color4b> mapColours(const Eigen::VectorXd& values, const ColourRange& range);

} // namespace developable::plugin
