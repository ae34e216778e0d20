// SPDX-License-Identifier: GPL-3.0-or-later
// panel_flattener.h: one panel laid flat, cut open where it has to be.
#pragma once

#include "flip_free_newton.h"
#include "panel_mesh.h"

namespace developable::detail {

/// A panel with its layout in the plane.
struct FlatPanel {
	PanelMesh mesh; ///< cut where it had to be
	PlanePositions positions;
	FlatMinimum minimum;
	int cuts = 0;
};

/// The strain of every edge, in the order of its first half edge.
Eigen::VectorXd edgeStrains(const FlatPanel& panel);

/// Lays a panel flat, uncut if it is a disk; see flattenPatches for when it is cut.
/// \param iterations  at most, for each layout that is tried
/// \param leastSquares  whether the minimum itself is asked for, not a layout near it with less mean strain
FlatPanel flattenPanel(const PanelMesh& panel, int iterations, bool leastSquares, const Progress& progress);

} // namespace developable::detail
