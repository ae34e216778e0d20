// SPDX-License-Identifier: GPL-3.0-or-later
// flatten.h: the front door of flatten/: patches laid flat at the model's own scale, with edges as long as
// they were or nearly (Fig. 1).
//
// flattenPatches makes patterns, measurePatterns measures them anew, findSeams says what is sewn to what, and
// largestAtPlaces shows a map of the patterns on the model. Lengths are in the model's unit.
#pragma once

#include "flat_patterns.h"
#include "grain_directions.h"
#include "held_grain.h"
#include "pattern_measures.h"
#include "seams.h"

#include "developable/mesh/mesh.h"

namespace developable {

struct FlattenOptions {
	double gap = -1; ///< between the pieces' boxes, length; −1: 2 % of the diagonal of the largest
	/// At most, for each piece. It takes 4 to 10 unless a panel folds, and ends then when more would gain
	/// little.
	int iterations = 400;
	/// What the material bears from the pattern to the model. Where that is nothing at all, edges keep their
	/// lengths as nearly as they can, whatever strain that leaves.
	StrainBounds bounds = {};
	Grain grain = Grain::LongestSeam; ///< of directed bounds
	/// Only whether there is a layout within the bounds: where none can be hoped for, the nearest to them is
	/// not looked for.
	bool onlyWithin = false;
	int threads = 0; ///< pieces laid flat side by side, with the same bits for any number; 0: all processors
};

/// Lays every patch flat: from the minimum of Σ (flattened length − length)² over its edges (Eq. 7) without
/// flipped triangles two steps on, to a layout whose mean edge strain is some per cent less and whose energy
/// is at most half a per cent more. Disks come out whole. Holes stay open and are never filled; a panel is
/// cut from hole to hole only where it can't be flat otherwise: the two ends of a tube, or where that lowers
/// the mean edge strain fourfold. Pieces show their outside (where most of a patch's area faces), are never
/// mirrored, stand upright by their longest seam and lie side by side at the model's scale.
///
/// With bounds, the layout is the one of least Σ (flattened length − length)² among those whose triangles all
/// are within them, to 1e-4 of strain; where no such layout was found, one that exceeds them little, and a
/// note says where.
///
/// \param positions  3 x places
/// \return           one piece per patch, measured; when the user asked for a stop, nothing but a report that
///                   says so
///
/// \throws ClosedPatch, NonOrientablePatch, PatchWithHandles  for patches that can't be flat; say how many
/// \throws InvalidParameter  when the gap is not a number or infinite, or bounds are none (see requireValid)
FlatPatterns flattenPatches(const PatchAssembly& assembly, const Positions& positions,
							const FlattenOptions& options = {}, const Progress& progress = {});

} // namespace developable
