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

/// The paper's way with fixed seams first, then from its end seams and all else by safe steps: a seam's move
/// changes several patches, and the paper's own steps, whether they help or not, would spoil more than they
/// gain. So G never ends higher than the first half leaves it.
LocalMethodReport seamsMoveLast(const PatchAssembly& assembly, Positions& positions,
								const LocalMethodOptions& options, const Progress& progress) {
	LocalMethodOptions first = options, last = options;
	first.assemblingVertices = AssemblingVertices::Fixed;
	first.maxOperations = (options.maxOperations + 1) / 2;
	last.descent = true;
	detail::LocalOptimizer fixed(assembly, positions, first), together(assembly, positions, last);
	Positions reached = positions;
	if (fixed.anyMovable()) {
		LocalMethodReport report = fixed.run(reached, partOf(progress, 0, 0.5));
		if (report.status == Status::Stopped)
			return report;
		if (converged(report.status)) {
			positions = reached;
			return report;
		}
		together.goOnFrom(fixed);
	}
	return together.run(positions, partOf(progress, 0.5, 1));
}

} // namespace

LocalMethodReport localMethod(const PatchAssembly& assembly, Positions& positions,
							  const LocalMethodOptions& options, const Progress& progress) {
	requireValid(options);
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	if (options.assemblingVertices == AssemblingVertices::MoveTogether && !options.descent)
		return seamsMoveLast(assembly, positions, options, progress);
	return detail::LocalOptimizer(assembly, positions, options).run(positions, progress);
}

} // namespace developable
