// SPDX-License-Identifier: GPL-3.0-or-later
// roughness.h: how wrinkled a shape is, which D and G do not say (Section 6 on Fig. 10).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// Root mean square of the angle between the normals of faces that share an edge of their patch, rad. Faces
/// of a patch count as oriented like its first one; seams between patches don't count. 0 where no faces are
/// neighbours.
double roughness(const PatchAssembly& assembly, const Positions& positions);

/// The integral of (abs(κ₁) + abs(κ₂)) / 2, the mean of the absolute principal curvatures, over all patches,
/// length: as in Steiner's formula half the sum of length times angle over the edges that faces share within
/// their patch. It hardly depends on how finely a smooth shape is meshed; one that crumples has several times
/// that of the smooth one.
double meanAbsoluteCurvature(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
