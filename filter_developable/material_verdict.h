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

/// Of one panel's pattern: by how much the material is strained on the model.
struct PanelStrain {
	double stretch = 0, compression = 0; ///< the greatest of its triangles
	double beyondBounds = 0;             ///< by how much one is beyond its bound, at most; 0: all are within
	Eigen::Vector3d at = {0, 0, 0};      ///< where that is, or the greatest strain, in the mesh's unit
};

/// Lays the shape flat within the bounds of its material, adds the pattern's strains and `collapsed_faces` to
/// the results and logs whether every panel is within its bounds, or which is beyond them, where and by how
/// much. Where the shape can't be laid flat at all the strains are -1. Collapsed faces get a warning.
/// \param positions  3 x places
/// \param known      where they are of these positions, they need not be made again
/// \return           of every panel, or none where the shape can't be laid flat
std::vector<PanelStrain> judgeMaterial(FilterCall& call, const PatchAssembly& assembly,
									   const Positions& positions, const KnownPatterns& known,
									   Results& results);

/// Writes the face attributes `panel_stretch`, `panel_compression`, `panel_beyond_bounds` (per cent) and
/// `panel_strain_point`.
void writeStrains(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<PanelStrain>& strains);

/// Logs how much of the area a sheet of the chosen thickness would be bent more tightly on than it bears;
/// nothing where the thickness is 0.
void judgeBending(FilterCall& call, const PatchAssembly& assembly, const Positions& positions);

} // namespace developable::plugin
