// SPDX-License-Identifier: GPL-3.0-or-later
// taut_curves.h: seams and darts that were drawn, pulled straight where they are.
#pragma once

#include "planned_surface.h"
#include "sharp_features.h"
#include "smooth_seams.h"

namespace developable::detail {

/// Seams and darts on a mesh with triangles split for them.
struct DrawnSeams {
	SplitMesh split;
	CutSurface surface; ///< of the split mesh
};

/// Per triangle of the mesh before it was split.
struct TautLimits {
	std::vector<char> held;  ///< no curve may cross it; or empty
	std::vector<char> stays; ///< curves on it stay as they are
};

/// Every seam and dart becomes the shortest curve near where it was, between the same ends: as taut as a
/// thread in a narrow channel. Seams on creases stay.
/// \param planned   the mesh before it was split
/// \param features  of it
/// \return          the same as it was where some panel would not be as it was
DrawnSeams pulledTaut(DrawnSeams drawn, const PlannedSurface& planned, const SharpFeatures& features,
					  const TautLimits& limits);

} // namespace developable::detail
