// SPDX-License-Identifier: GPL-3.0-or-later
// local_method.h: the paper's local method (Section 5): one vertex at a time along its normal, worst first.
#pragma once

#include "detail/local_optimizer.h"

namespace developable {

namespace detail {

inline void requireSensible(const LocalMethodOptions& options) {
	if (options.maxDisplacement != LocalMethodOptions::meanEdge && !(options.maxDisplacement >= 0))
		throw InvalidParameter("The largest displacement is " + std::to_string(options.maxDisplacement) +
							   ": choose 0 or more, or -1 for the mean edge length.");
	if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
		throw InvalidParameter("The smoothing is " + std::to_string(options.smoothing) +
							   ": choose 0 or more.");
}

} // namespace detail

/// Moves vertices along their original normals until no angle defect exceeds the tolerance. Vertices on a
/// free edge of the object stay, and so do those where patches meet unless they may move together; the others
/// stay within ±δ_T of where they were. G never ends higher. \param positions  3 x places: in, the start;
/// out, the state of lowest G, or unchanged when stopped \throws ClosedPatch, NonOrientablePatch, NothingFree
/// \throws InvalidParameter  when an option is out of its range
inline LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
									 const LocalMethodOptions& options, const Progress& progress = {}) {
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	detail::requireSensible(options);
	return detail::LocalOptimizer(assembly, positions, options).run(positions, progress);
}

} // namespace developable
