// SPDX-License-Identifier: GPL-3.0-or-later
// local_method.cpp: what the local method requires of its input before it runs.
#include "local_method.h"

#include "local_optimizer.h"

#include <cmath>
#include <string>

namespace developable {

namespace {

void requireSensible(const LocalMethodOptions& options) {
	if (options.maxDisplacement != LocalMethodOptions::meanEdge && !(options.maxDisplacement >= 0))
		throw InvalidParameter("The largest displacement is " + std::to_string(options.maxDisplacement) +
							   ": choose 0 or more, or -1 for the mean edge length.");
	if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
		throw InvalidParameter("The smoothing is " + std::to_string(options.smoothing) +
							   ": choose 0 or more.");
}

} // namespace

LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
							  const LocalMethodOptions& options, const Progress& progress) {
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	requireSensible(options);
	return detail::LocalOptimizer(assembly, positions, options).run(positions, progress);
}

} // namespace developable
