// SPDX-License-Identifier: GPL-3.0-or-later
// relief_darts.h: darts where panels that are sewn together pull each other too far.
#pragma once

#include "cut_surface.h"

namespace developable::detail {

/// The share that is tried first.
constexpr double firstDartLength = 0.15;

struct Dart {
	double length = 0; ///< 0: there was no room for one
	Eigen::Vector3d tip = Eigen::Vector3d::Zero();
};

/// Cuts a dart into a panel: from its border, or a cut, to a point inside; where the point is on the border
/// itself, from there inwards, away from the border as far as the length leads.
/// \param at      a vertex of the panel is there, or nearly
/// \param held    per triangle whether it is held: no dart runs between two of these; or empty
/// \param share   of the root of the panel's area: the length of a dart that begins at the point
Dart cutDart(CutSurface& surface, int panel, const Eigen::Vector3d& at, double share,
			 const std::vector<char>& held);

} // namespace developable::detail
