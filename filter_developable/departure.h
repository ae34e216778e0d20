// SPDX-License-Identifier: GPL-3.0-or-later
// departure.h: how far a result is from what it began as, in numbers that a user should be warned of.
#pragma once

#include "filter_call.h"
#include "results.h"

#include "developable/mesh/mesh.h"

namespace developable::plugin {

/// What the log says when a result is above a limit.
struct Warning {
	const char* key; ///< of what is measured
	double limit;
	const char* text; ///< {names} stand for results with these keys
};

/// Of an optimisation.
inline constexpr Warning departureWarnings[] = {
	{"max_displacement_per_cent", 5,
	 "far from its input: a vertex moved by {max_displacement} units of the mesh, {max_displacement_per_cent} % "
	 "of its part's diagonal"},
	{"folded_faces", 0, "{folded_faces} faces are folded over their neighbours"},
	{"shrunken_patches", 0, "{shrunken_patches} of {patches} patches lost more than half of their area"},
	{"collapsed_faces", 0,
	 "laid flat as it is, {collapsed_faces} faces collapse, thinner than a tenth: their stretch counts as 900 %"},
};

/// Logs the sentences of those results that are above their limits.
void logWarnings(const FilterCall& call, const Results& results);

/// The largest displacement beside the diagonal of the box of its part (see partsOf) as it was, per cent.
/// \param positions  3 x places
double farthestInPerCent(const PatchAssembly& assembly, const Positions& positions);

/// Logs all that an optimisation is warned of, with what is counted here: faces at edges whose normals made
/// less than 90° and make more than 120°; patches whose area is less than half of what it was.
/// \param results  with the other numbers that the sentences take
void logDepartures(const FilterCall& call, Results results, const PatchAssembly& assembly,
				   const Positions& positions);

} // namespace developable::plugin
