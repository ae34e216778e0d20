// SPDX-License-Identifier: GPL-3.0-or-later
// sharp_features.h: creases and sharp points, those apart that are only the corners of a round shape.
#pragma once

#include "cut_surface.h"

namespace developable::detail {

/// Where seams like to be. A round shape of few triangles turns sharply at all its edges and points: a seam
/// is as good beside these as on them. What turns much more than what is next to it was made so, and a smooth
/// line that turns by more than the sides of anything round.
struct SharpFeatures {
	enum Kind : char { None, AmongOthers, Alone };

	std::vector<Kind> edges;  ///< per half edge
	std::vector<Kind> points; ///< per copy
};

/// \param creaseAngle  edges with a smaller turn are none, degrees
SharpFeatures sharpFeatures(const CutSurface& surface, double creaseAngle);

/// The angle between the normals of the two triangles at a half edge, rad; 0 at a border.
double turnAt(const CutSurface& surface, int halfEdge);

} // namespace developable::detail
