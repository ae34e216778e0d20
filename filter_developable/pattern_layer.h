// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layer.h: flat patterns as a layer of their own, and as texture coordinates.
#pragma once

#include "layer.h"

#include "developable/flatten/flatten.h"

namespace developable::plugin {

/// Fills an empty layer: vertex i is vertex i of the patterns, face i is triangle i, in the plane z = 0.
/// \param lengthExponent  of the assembly that they are patterns of
void writePatterns(Layer& layer, const FlatPatterns& patterns, int lengthExponent);

/// Says of the sides of the layer's faces what is sewn to them, in three custom attributes of three numbers a
/// face, one for the side from each corner to the next: `seam`, from 1, or 0 where there is none;
/// `seam_edge`, the place of the side along that seam, from 0; `sewn_to`, what it is sewn to, as 3 x face +
/// side. Only the first side of each seam has them, as an edge may be the second side of several seams.
void writeSeams(Layer& layer, const std::vector<Seam>& seams);

/// The patterns' coordinates as texture coordinates of the faces that they were made of, scaled to fit the
/// unit square.
void writeTextureCoordinates(Layer& layer, const PatchAssembly& assembly, const FlatPatterns& patterns);

} // namespace developable::plugin
