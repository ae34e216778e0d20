// SPDX-License-Identifier: GPL-3.0-or-later
// flat_start.h: first layouts of a panel in the plane: a conformal one, exact for developable panels, and one
// that never flips a triangle.
#pragma once

#include "panel_mesh.h"

namespace developable::detail {

/// The conformal map of a disk that leaves boundary lengths as they are (Sawhney and Crane, "Boundary First
/// Flattening", 2017): of all conformal maps it has the least distortion of area, and a developable disk
/// comes out isometric. It may flip triangles of other disks.
///
/// \return 2 x vertices, or none when it can't be found
PlanePositions conformalStart(const PanelMesh& disk);

/// Tutte's embedding: the longest boundary on a circle, every other vertex the mean of its neighbours.
/// Without flips for every disk; the other boundaries are closed by a vertex each, in here only.
///
/// \param loops  the panel's boundary loops
/// \return       2 x vertices, at the scale of the panel's area, or none when it can't be found
PlanePositions circleStart(const PanelMesh& panel, std::vector<std::vector<int>> loops);

} // namespace developable::detail
