// SPDX-License-Identifier: GPL-3.0-or-later
// reference_shape.h: the shape that the maps Distance and Displacement are measured from.
#pragma once

#include "filter_call.h"

#include "developable/mesh/mesh.h"

#include <optional>

namespace developable::plugin {

struct ReferenceShape {
	Positions vertices;         ///< of its surface, in the coordinates of the current layer
	Eigen::Matrix3Xi triangles; ///< of its surface
	std::optional<Positions>
		places; ///< where the assembly's places were; absent when its vertices are not ours
};

/// The layer that the parameter `reference` names; for the current one the shape that its last optimisation
/// started from, or nothing when there was none.
/// \throws EmptyMesh, InvalidCoordinate  when another layer was chosen that has no surface to measure to
std::optional<ReferenceShape> referenceShape(FilterCall& call, const PatchAssembly& assembly);

} // namespace developable::plugin
