// SPDX-License-Identifier: GPL-3.0-or-later
// symmetric_joining.h: panels that mirror each other, joined in pairs.
#pragma once

#include "join_history.h"
#include "mirror_plane.h"
#include "panel_tests.h"

namespace developable::detail {

/// Labels of which those of one side are the mirror image of the other's: a label that crosses the plane
/// falls apart there.
/// \param mirrored  per triangle, the one at its mirror image
std::vector<int> symmetricLabels(const CutSurface& surface, const MirrorPlane& plane,
								 const std::vector<int>& mirrored);

/// Joins panels across their longest seams, and those at the mirror image at once, wherever both unions are
/// panels: so pairs stay pairs, and what crosses the plane is its own mirror image.
void joinSymmetrically(CutSurface& surface, PanelTests& tests, JoinHistory& history, const MirrorPlane& plane,
					   const std::vector<int>& mirrored);

/// Takes back the last joins of panels, and those at their mirror images. \return whether there was any
bool takeBackSymmetrically(CutSurface& surface, const std::vector<int>& panels, JoinHistory& history,
						   const std::vector<int>& mirrored);

} // namespace developable::detail
