// SPDX-License-Identifier: GPL-3.0-or-later
// seam_smoothing.h: seams as smooth as all panels still hold with, when they are sewn together.
#pragma once

#include "mirror_plane.h"
#include "seam_drawing.h"
#include "sewn_panels.h"

#include <functional>

namespace developable::detail {

/// What is done with a surface as it is.
struct SewingSteps {
	std::function<SewnPanels()> sew;
	std::function<SewnPanels(SewnPanels)> close;   ///< overlaps, where that makes all hold
	std::function<SewnPanels(SewnPanels)> relieve; ///< alike, and with darts where that makes all hold
	std::function<bool()> mayGoOn;
};

/// Draws the seams of panels in several manners: of those with which all panels hold the shortest is kept.
class SeamSmoothing {
public:
	/// \param planned   gets the seams
	/// \param clusters  as in SeamDrawing, as are the darts' tips
	/// \param mirror    seams keep to it, or null
	SeamSmoothing(PlannedSurface& planned, const std::vector<int>& clusters,
				  const std::vector<Eigen::Vector3d>& dartTips, const CutOptions& options,
				  const MirrorPlane* mirror, SewingSteps steps);
	SeamSmoothing(const SeamSmoothing&) = delete;

	/// \param smoothest  Smooth or Taut: what is drawn at most
	/// \return           what becomes of the panels
	SewnPanels run(SeamDrawing::Manner smoothest = SeamDrawing::Manner::Smooth);

	/// The seams that were moved least of those that hold.
	const PlannedSurface& safest() const { return safest_; }

private:
	bool holds(const SewnPanels& sewn) const;
	bool tryDrawing(SeamDrawing& drawing, int rounds, SewnPanels& sewn);

	PlannedSurface& planned_;
	const PlannedSurface before_;
	SeamDrawing taut_, smooth_; // of what was before
	const MirrorPlane* mirror_;
	const SewingSteps steps_;
	PlannedSurface safest_;
};

} // namespace developable::detail
