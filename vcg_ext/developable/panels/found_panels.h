// SPDX-License-Identifier: GPL-3.0-or-later
// found_panels.h: the best panels of several searches, or those that mirror each other.
#pragma once

#include "planned_surface.h"
#include "search_input.h"
#include "sewn_panels.h"

namespace developable::detail {

struct FoundPanels {
	/// The best first, others that may do where that does not hold; not empty but after a stop.
	std::vector<PlannedSurface> planned;
	SewnPanels sewn;   ///< what becomes of the best
	bool hold = false; ///< whether they do when they are sewn together
	bool stopped = false;
	std::vector<std::string> notes; ///< as in CutReport
};

inline constexpr const char* noteOnDivided =
	"Not all panels mirror each other: what did not hold among the others had to be divided. A larger displacement "
	"may help.";

/// Joining is greedy, and where it ends is much a matter of where it begins: it is done from several sets of
/// clusters, and what comes to short seams and few panels is sewn together first; another where it promises
/// more than came of that, and all where it takes little time. Of what holds the fewest panels are taken, of
/// as many the shortest seams.
FoundPanels findPanels(const SearchInput& input, const Progress& progress);

/// Panels that mirror each other, where the surface is its own mirror image; else any, with a note.
FoundPanels findSymmetricPanels(const SearchInput& input, const Progress& progress);

} // namespace developable::detail
