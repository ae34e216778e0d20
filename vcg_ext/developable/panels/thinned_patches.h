// SPDX-License-Identifier: GPL-3.0-or-later
// thinned_patches.h: a copy of a surface with fewer triangles, to look for its panels on.
#pragma once

#include "cut_into_panels.h"
#include "planned_surface.h"

namespace developable::detail {

/// Panels that were found on another copy of a surface.
struct CarriedPanels {
	PlannedSurface planned;    ///< seams and darts along edges
	std::vector<int> clusters; ///< per triangle; both sides of any cut differ
};

/// Where seams run is a matter of the large shape: on a scan of many triangles they are looked for on a few.
class ThinnedPatches {
public:
	/// \param given   outlives this
	/// \param places  so many, or more where patches can't do with these, see coarserLevel
	ThinnedPatches(const GivenPatches& given, int places);

	/// Every copy of a vertex is a vertex here, and every triangle a face.
	const GivenPatches& patches() const { return thin_; }

	/// \param ofGiven  per patch of what was given
	/// \return         per patch here
	std::vector<double> limits(const std::vector<double>& ofGiven) const;

	/// Panels found here on what was given: each of its triangles goes to the panel that is nearest.
	CarriedPanels carriedBack(const PlannedSurface& planned, const CutOptions& options) const;

private:
	std::vector<int> nearestLabels(const PlannedSurface& planned, const std::vector<int>& labels) const;

	const GivenPatches& given_;
	PatchAssembly assembly_; // of what was given
	GivenPatches thin_;
	std::vector<int> patchGiven_; // per triangle here
};

} // namespace developable::detail
