// SPDX-License-Identifier: GPL-3.0-or-later
// flatten.cpp: what can be laid flat, and laying it flat.
#include "flatten.h"

#include "pattern_maker.h"

#include <cmath>

namespace developable {

FlatPatterns flattenPatches(const PatchAssembly& assembly, const Positions& positions,
							const FlattenOptions& options, const Progress& progress) {
	if (!std::isfinite(options.gap))
		throw InvalidParameter(
			"The gap between pieces is not a number: choose a length, or -1 for the default.");
	requireOption(options.threads >= 0, "The number of threads must not be negative.");
	requireValid(options.bounds);
	requireOpenPatches(assembly);
	requireOrientablePatches(assembly);
	detail::PatternMaker maker(assembly, positions);
	if (!maker.flattenPanels(options.iterations, options.bounds.any(), options.threads, progress)) {
		FlatPatterns none;
		none.report.stopped = true;
		return none;
	}
	maker.keepWithin(options.bounds, options.grain, options.onlyWithin, options.threads);
	return maker.makePatterns(options.gap);
}

} // namespace developable
