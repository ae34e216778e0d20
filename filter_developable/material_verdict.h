// SPDX-License-Identifier: GPL-3.0-or-later
// material_verdict.h: what a material would say of a shape and its pattern.
#pragma once

#include "filter_call.h"
#include "results.h"

#include "developable/flatten/flatten.h"

namespace developable::plugin {

/// `max_stretch` and `max_compression` of patterns, per cent.
void addStrains(Results& results, const FlattenReport& report);

/// A shape, 3 x places, and its patterns within the bounds of its material; none: without columns.
struct KnownPatterns {
	Positions shape;
	FlatPatterns patterns;
};

/// Lays the shape flat within the bounds of its material, adds the pattern's strains and `collapsed_faces` to
/// the results and logs whether every panel is within its bounds, or which is beyond them, where and by how
/// much. Where the shape can't be laid flat at all the strains are -1. Collapsed faces get a warning.
/// \param positions  3 x places
/// \param known      where they are of these positions, they need not be made again
void judgeMaterial(FilterCall& call, const PatchAssembly& assembly, const Positions& positions,
				   const KnownPatterns& known, Results& results);

/// Logs how much of the area a sheet of the chosen thickness would be bent more tightly on than it bears;
/// nothing where the thickness is 0.
void judgeBending(FilterCall& call, const PatchAssembly& assembly, const Positions& positions);

} // namespace developable::plugin
