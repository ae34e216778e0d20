// SPDX-License-Identifier: GPL-3.0-or-later
// colour_map.h: the colours that a map of values is shown in.
//
// Both ramps go through OKLab (B. Ottosson, "A perceptual color space for image processing", 2020) at
// constant speed, so that equal steps in value look equal, and lightness tells values apart without hue. They
// are light at 0, so that the shape stays visible. The Python package has them as a table (colour_table.cpp).
#pragma once

#include <Eigen/Core>
#include <string>
#include <vcg/space/color4.h>
#include <vector>

namespace developable::plugin {

/// Of the values that are more than noise, how many a range shows in full.
constexpr double shownShare = 0.98;

/// The values that the first and the last colour stand for.
struct ColourRange {
	double low = 0; ///< 0, or where the map is signed -high
	double high = 0;

	bool isSigned() const { return low < 0; }
};

/// The range that shows 98 % of the values in full; the few beyond take the last colour. From 0 for one-sided
/// maps, symmetric about 0 for signed ones.
/// \param noise  absolute values up to this are as good as 0: they do not count, and the range reaches at
/// least
///               so far; positive
ColourRange colourRange(const Eigen::VectorXd& values, bool isSigned, double noise);

/// One colour per value: one-sided maps go from light yellow by red to dark violet along a helix, signed ones
/// from blue by light grey to red along straight lines.
std::vector<vcg::Color4b> mapColours(const Eigen::VectorXd& values, const ColourRange& range);

/// What the log says of the colours: the range, and how many values lie beyond it.
/// \param high  the range's end, with its unit
std::string describe(const ColourRange& range, const std::string& high, const Eigen::VectorXd& values);

} // namespace developable::plugin
