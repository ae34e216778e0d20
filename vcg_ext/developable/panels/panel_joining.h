// SPDX-License-Identifier: GPL-3.0-or-later
// panel_joining.h: panels are joined across their seams, the longest first, as long as that makes panels.
#pragma once

#include "join_history.h"
#include "panel_tests.h"
#include "seam_chains.h"

#include <functional>

namespace developable::detail {

/// How far the panels of a surface are from becoming developable when they are sewn together; 0: they do.
using SewnExcess = std::function<double()>;

/// Joins that are only kept when the panels, sewn together, are no worse than before. Sewing takes long:
/// after some that were worse no more are tried.
class SewnJoining {
public:
	SewnJoining(CutSurface& surface, SewnExcess excess) : surface_(surface), excess_(std::move(excess)) {}

	/// Joins across some half edges, or not. What is small compared with its patch has little to pull with,
	/// and is not tried. \return whether it did
	bool join(const std::vector<int>& halfEdges);

private:
	CutSurface& surface_;
	const SewnExcess excess_;
	double before_ = -1; // not known
	int failures_ = 0;
};

/// Joins panels across whole seams, greedily: those whose union is a panel by itself, and promising.
/// \param mayGo  which seams are tried; all when it is empty
void joinPanels(CutSurface& surface, PanelTests& tests, JoinHistory& history,
				const std::function<bool(const SeamChain&)>& mayGo = {});

/// Joins panels across whole seams where their union is a panel once it has darts that are shorter than the
/// seam.
/// \param tips  of the darts; new ones are added
/// \param held  per triangle whether it is held: no dart runs between two of these; or empty
void joinWithRelief(CutSurface& surface, PanelTests& tests, JoinHistory& history,
					std::vector<Eigen::Vector3d>& tips, const std::vector<char>& held = {});

/// Where a whole seam can't go, a long part of it does, from one of its ends on; the rest stays as a dart.
void joinWithDarts(CutSurface& surface, PanelTests& tests, const SewnExcess& excess);

} // namespace developable::detail
