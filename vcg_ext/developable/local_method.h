// SPDX-License-Identifier: GPL-3.0-or-later
// local_method.h: the paper's local method (Section 5): one vertex at a time along its normal, worst first.
#pragma once

#include "detail/local_optimizer.h"

namespace developable {

/// Moves vertices along their original normals until no angle defect exceeds the tolerance. Vertices on a
/// boundary or where patches meet stay; the others stay within ±δ_T of where they were. G never ends higher.
/// \param positions  3 x places: in, the start; out, the state of lowest G, or unchanged when stopped
/// \throws ClosedPatch, NonOrientablePatch, NothingFree
/// \throws InvalidParameter  when the limits make no sense
inline LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
									 const LocalMethodOptions& options, const Progress& progress = {}) {
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	if (options.maxDisplacement != LocalMethodOptions::meanEdge && !(options.maxDisplacement >= 0))
		throw InvalidParameter("The largest displacement is " + std::to_string(options.maxDisplacement) +
							   ": choose 0 or more, or -1 for the mean edge length.");
	return detail::LocalOptimizer(assembly, positions, options).run(positions, progress);
}

} // namespace developable
