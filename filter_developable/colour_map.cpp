// SPDX-License-Identifier: GPL-3.0-or-later
// colour_map.cpp: values to colours, by vcglib's ramp.
#include "colour_map.h"

#include <algorithm>

namespace developable::plugin {

ColourRange colourRange(const Eigen::VectorXd& values, bool isSigned) {
	double largest = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
	if (largest == 0)
		largest = 1;
	return {isSigned ? -largest : 0, largest};
}

std::vector<vcg::Color4b> mapColours(const Eigen::VectorXd& values, const ColourRange& range) {
	std::vector<vcg::Color4b> colours;
	colours.reserve(std::size_t(values.size()));
	for (const double value : values) {
		const double share = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
		vcg::Color4b colour;
		colour.SetColorRamp(0, 1, static_cast<float>(1 - share)); // vcglib's ramp begins with red
		colours.push_back(colour);
	}
	return colours;
}

} // namespace developable::plugin
