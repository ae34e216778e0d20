// SPDX-License-Identifier: GPL-3.0-or-later
// overlap_closing.h: panels that overlap themselves a little, where a dart or a notch of their border ends.
#pragma once

#include "sewn_panels.h"

#include <functional>

namespace developable::detail {

/// Where the surface is a saddle, the two sides of a dart's tip, or of a neighbour's corner, lie upon each
/// other when the panel is laid flat. A dart is closed as far as they do; else the panel takes the triangles
/// at the other side of its border there, or a slit runs at their other side.
/// \param notch  half edges along the panel's border, from one side to the other
/// \param held   per triangle whether it has to stay with others; or empty
/// \return       whether that was possible: no panel falls apart or gets a hole
bool closeNotch(CutSurface& surface, int panel, const std::vector<int>& notch,
				const std::vector<char>& held = {});

/// What is done with a surface as it is.
struct ClosingSteps {
	std::function<SewnPanels()> sew;
	std::function<SewnPanels(const SewnPanels& shape)> look; ///< see overlapsOfShape
	std::function<bool()> mayGoOn;
};

/// Closes notches, round by round, as long as panels fail for nothing but overlaps.
/// \param held  as above
/// \param sewn  the surface as it is
/// \return      the surface as it is afterwards; panels may fail still, or for other reasons
SewnPanels closeOverlaps(CutSurface& surface, const std::vector<char>& held, SewnPanels sewn,
						 const ClosingSteps& steps);

} // namespace developable::detail
