// SPDX-License-Identifier: GPL-3.0-or-later
// local_method_options.h: what can be set for the local method, and what it reports.
#pragma once

#include "report.h"

namespace developable {

/// What the local method does with vertices where patches meet.
enum class AssemblingVertices {
	Fixed,       ///< they stay, as in the paper (Section 5.2.3)
	MoveTogether ///< linked copies move as one, for the sum of what each patch gains
};

/// With the defaults from `descent` on the method is the paper's. They are what its Section 7 asks for.
struct LocalMethodOptions {
	static constexpr double meanEdge = -1;

	double angleTolerance = 1e-4; ///< √ε: stop when the largest abs(g) of a movable vertex is this small, rad
	double maxDisplacement = meanEdge; ///< δ_T: largest move along the original normal, length; -1: L̄
	long maxOperations = 500000;       ///< N_max
	bool descent = false;              ///< halve a move until it lowers T; set the vertex aside if none does
	double smoothing =
		0; ///< weight in T of uneven moves: mean square difference to neighbours in mean edges, rad²
	AssemblingVertices assemblingVertices = AssemblingVertices::Fixed;
	bool avoidSelfIntersections = false; ///< no move may make the surface cut itself
	bool roundedToFloat = false;         ///< nor as a mesh in float will hold it
};

struct LocalMethodReport : OptimizationReport {
	long setAside = 0;     ///< vertices that could not move any more when the run ended
	long refusedMoves = 0; ///< moves not made because the surface would have cut itself
};

} // namespace developable
