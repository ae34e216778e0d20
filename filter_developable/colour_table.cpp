// SPDX-License-Identifier: GPL-3.0-or-later
// colour_table.cpp: the colours of maps as the plugin's file hands them to other programs, which so need no
// ramps of their own. python/generate_colours.py reads them.
#include "colour_map.h"

#include <QtGlobal>

extern "C" {

Q_DECL_EXPORT void developable_colours(int isSigned, int count, unsigned char* colours);
Q_DECL_EXPORT double developable_shown_share();

/// The colours at equal steps from the first, of −1 where the map is signed and else of 0, to that of 1.
/// \param count  at least 2
/// \param colours  3 x count bytes, sRGB, that are filled
void developable_colours(int isSigned, int count, unsigned char* colours) {
	const developable::plugin::ColourRange range{isSigned != 0 ? -1.0 : 0.0, 1.0};
	const Eigen::VectorXd shares = Eigen::VectorXd::LinSpaced(count, range.low, range.high);
	for (const vcg::Color4b& colour : developable::plugin::mapColours(shares, range))
		for (int channel = 0; channel < 3; ++channel)
			*colours++ = colour[channel];
}

/// The share of a map's values that its range shows in full.
double developable_shown_share() {
	return developable::plugin::shownShare;
}
}
