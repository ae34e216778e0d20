// SPDX-License-Identifier: GPL-3.0-or-later
// seam_chains.h: the seams and darts of a cut surface as curves, from junction to junction.
#pragma once

#include "cut_surface.h"

#include <array>
#include <functional>

namespace developable::detail {

/// A curve of cuts between the same two panels, or within one, that ends at a border, where other cuts begin,
/// at a sharp point, or inside a panel.
struct SeamChain {
	std::vector<int> halfEdges; ///< one of each edge, in order
	std::array<int, 2> panels = {-1, -1};
	std::array<int, 2> ends = {-1, -1};           ///< copies; equal when it is closed
	std::array<bool, 2> freeEnd = {false, false}; ///< no cut and no border there: the tip of a dart
	double length = 0;

	bool within() const { return panels[0] == panels[1]; }
	bool isDart() const { return within() && (freeEnd[0] || freeEnd[1]); }
};

/// In the order of their first half edges.
std::vector<SeamChain> seamChains(const CutSurface& surface);

/// The same, the longest first.
std::vector<SeamChain> longestFirst(std::vector<SeamChain> chains);

/// The first of some chains, so many at most, no two of which have a panel in common.
/// \param mayTake  asked of those only that have none in common with what was taken; all may be when it is
/// empty
std::vector<SeamChain> firstApart(const std::vector<SeamChain>& chains, int most,
								  const std::function<bool(const SeamChain&)>& mayTake = {});

/// Of all seams and darts, each counted once.
double seamLength(const CutSurface& surface);

} // namespace developable::detail
