// SPDX-License-Identifier: GPL-3.0-or-later
// without_detail.h: a surface without noise and fine detail.
#pragma once

#include "newton_tuning.h"

#include "developable/mesh/mesh.h"

#include <optional>

namespace developable {

/// Noise and fine detail have most of the curvature of a surface that has them, and are next to nothing
/// beside how far its places may move: once its panels are developable all of it is gone. What they come to
/// is a matter of the rest: of the surface without waves shorter than a few edges, by steps towards what has
/// the least unfairness (see detail::Unfairness). Held places stay. Features that few triangles have to do
/// for are no detail: what goes of these is alike at neighbours.
/// \param farthest     how far places may move, length
/// \param memoryLimit  see SparseSolver
/// \return             the same patches with other original positions; nothing where that takes away less of
///                     the curvature, or moves more, than is worth it
std::optional<PatchAssembly> withoutDetail(const PatchAssembly& original, double farthest,
										   const NewtonTuning& tuning = {}, double memoryLimit = 0);

/// What was smoothed away takes room, too: so much less may places move from there, length.
double roomOfDetail(const PatchAssembly& original, const PatchAssembly& smoothed);

} // namespace developable
