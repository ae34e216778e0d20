// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layer.h: flat patterns as a layer of their own, and as texture coordinates.
#pragma once

#include "layer.h"

#include "developable/flatten/flatten.h"

namespace developable::plugin {

/// Fills an empty layer: vertex i is vertex i of the patterns, face i is triangle i, in the plane z = 0.
void writePatterns(Layer& layer, const FlatPatterns& patterns);

/// The patterns' coordinates as texture coordinates of the faces that they were made of, scaled to fit the
/// unit square.
void writeTextureCoordinates(Layer& layer, const PatchAssembly& assembly, const FlatPatterns& patterns);

} // namespace developable::plugin
