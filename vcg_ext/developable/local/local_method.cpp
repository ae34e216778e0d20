// SPDX-License-Identifier: GPL-3.0-or-later
// local_method.cpp: what the local method requires of its input before it runs.
#include "local_method.h"

#include "local_optimizer.h"

#include <cmath>
#include <string>

namespace developable {

namespace {

void requireValid(const LocalMethodOptions& options) {
	requireOption(options.angleTolerance >= 0, "The angle tolerance must not be negative.");
	requireOption(options.maxDisplacement == LocalMethodOptions::meanEdge || options.maxDisplacement >= 0,
				  "The largest displacement is " + std::to_string(options.maxDisplacement) +
					  ": choose 0 or more, or -1 for the mean edge length.");
	requireOption(options.maxOperations >= 0, "The limit of operations must not be negative.");
	requireOption(options.smoothing >= 0 && std::isfinite(options.smoothing),
				  "The smoothing is " + std::to_string(options.smoothing) + ": choose 0 or more.");
}

} // namespace

LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
							  const LocalMethodOptions& options, const Progress& progress) {
	requireValid(options);
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	return detail::LocalOptimizer(assembly, positions, options).run(positions, progress);
}

} // namespace developable
