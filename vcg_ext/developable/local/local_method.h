// SPDX-License-Identifier: GPL-3.0-or-later
// local_method.h: the front door of local/: the paper's local method (Section 5).
//
// One vertex at a time is moved along its normal, the worst first.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// What the local method does with vertices where patches meet.
enum class AssemblingVertices {
	Fixed, ///< they stay, as in the paper (Section 5.2.3)
	/// Linked copies move as one, for the sum of what each patch gains. Without `descent` the first half of
	/// the operations leaves them fixed, and the second takes steps that lower T only.
	MoveTogether
};

/// With the defaults from `descent` on the method is the paper's. They are what its Section 7 asks for.
struct LocalMethodOptions {
	static constexpr double meanEdge = -1;

	/// √ε: stop when the largest abs(g) of a movable vertex is this small, rad
	double angleTolerance = 1e-4;
	double maxDisplacement = meanEdge; ///< δ_T: largest move along the original normal, length; -1: L̄
	long maxOperations = 500000;       ///< N_max
	bool descent = false;              ///< halve a move until it lowers T; set the vertex aside if none does
	/// weight in T of uneven moves: mean square difference to neighbours in mean edges, rad²
	double smoothing = 0;
	AssemblingVertices assemblingVertices = AssemblingVertices::Fixed;
	bool avoidSelfIntersections = false; ///< no move may make the surface cut itself
	bool roundedToFloat = false;         ///< nor as a mesh in float will hold it
};

struct LocalMethodReport : OptimizationReport {
	long setAside = 0;     ///< vertices that could not move any more when the run ended
	long refusedMoves = 0; ///< moves not made because the surface would have cut itself
};

/// Moves vertices along their original normals until no angle defect exceeds the tolerance. Vertices on a
/// free edge of the object stay, and so do those where patches meet unless they may move together; the others
/// stay within ±δ_T of where they were. G never ends higher.
/// \param positions  3 x places, in the mesh's unit of length as δ_T is: in, the start;
///                   out, the state of lowest G, or unchanged when stopped
/// \param progress   is told the share of the work that is done, and may ask for a stop
/// \return           how the run ended, after how many operations, and what kept vertices from moving
/// \throws ClosedPatch, NonOrientablePatch, NothingFree
/// \throws InvalidParameter  when an option is out of its range
LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
							  const LocalMethodOptions& options, const Progress& progress = {});

} // namespace developable
