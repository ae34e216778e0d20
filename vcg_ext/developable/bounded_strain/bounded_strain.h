// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_strain.h: the front door of bounded_strain/: the nearest shape that has a pattern within the bounds
// of its material.
#pragma once

#include "developable/flatten/flatten.h"
#include "developable/material/material.h"
#include "developable/mesh/mesh.h"

namespace developable {

struct BoundedStrainOptions {
	StrainBounds bounds;              ///< must allow some strain; without any, see constrainedNewton
	Grain grain = Grain::LongestSeam; ///< of directed bounds
	double smoothness = 3e-6;         ///< as in ConstrainedNewtonOptions; so are the next two
	double fairness = 0;
	double maxDisplacement = -1;
	/// The smallest radius that places are to be bent to, length; 0: any. The shape stays above it where
	/// strains within the bounds let it.
	double leastRadius = 0;
	/// How far places may be from the original ones on average, on the way, too, length; 0: any. A run that
	/// goes beyond has failed.
	double meanOnWay = 0;
	int maxIterations = 200;  ///< steps, each with one linear system
	double tolerance = 2e-5;  ///< by how much a strain may be beyond its bound: less than in layouts
	bool searchBeyond = true; ///< for OptimizationReport::nearestDevelopable, where none was found within
							  ///< maxDisplacement
	/// Whether parts of up to 500 places are also looked for by way of shapes that are nearest at other
	/// smoothnesses, which takes about five times as long.
	bool severalStarts = true;
	int threads = 0; ///< on which parts are solved side by side; 0: as many as can work
};

struct BoundedStrainReport : OptimizationReport {
	double beyondBounds = 0; ///< by how much a strain is beyond its bound, at most
	/// Of the result, as flattenPatches makes them of it, where the object is one part; else without pieces.
	FlatPatterns patterns;
};

/// Moves the places to the shape nearest to the original ones, in the metric of the constrained Newton
/// method, that has a flat pattern from which no triangle is stretched or compressed beyond the bounds. Shape
/// and pattern are unknowns of one problem. Places are those of the object, so seams stay closed. No place
/// goes farther than the largest displacement, not by a bit. Parts (see partsOf) are solved each by itself;
/// the result is the same to the last bit on any number of threads.
///
/// \param positions  3 x places: where to start, and the result; untouched when stopped, and where that fits
/// \return           Converged; NothingToDo: the start has such a pattern; NeedsCut, or Stalled where places
///                   are held still: no such shape was found, and the result is beyond the bounds;
///                   LimitReached; Stopped. Of several parts the worst tells.
/// \throws InvalidParameter, ClosedPatch, NonOrientablePatch, PatchWithHandles, NothingFree
BoundedStrainReport boundedStrain(const PatchAssembly& assembly, Positions& positions,
								  const BoundedStrainOptions& options, const Progress& progress = {});

} // namespace developable
