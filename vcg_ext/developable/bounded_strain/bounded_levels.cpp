// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_levels.cpp: coarse levels first, then refinement.
#include "bounded_levels.h"

namespace developable::detail {

namespace {

constexpr int coarsest = 2500;         ///< places; so few are solved directly
constexpr int levelRatio = 4;          ///< between the numbers of places of two levels
constexpr double leastReduction = 0.6; ///< of places, for a coarse level that is worth its while
constexpr double softStart = 0.1;      ///< κ where a run begins from the original
constexpr double hardStart = 100;      ///< and from a coarser level's result

} // namespace

LevelOutcome BoundedLevels::solve(const PatchAssembly& assembly, const Positions& start,
								  const Progress& progress) const {
	if (assembly.placeCount() > coarsest) {
		const PartialAssembly coarse = coarserLevel(assembly, assembly.placeCount() / levelRatio);
		if (coarse.assembly.placeCount() < leastReduction * assembly.placeCount())
			return refine(assembly, start, coarse, progress);
	}
	return continueFrom(assembly, start, softStart, progress);
}

LevelOutcome BoundedLevels::refine(const PatchAssembly& assembly, const Positions& start,
								   const PartialAssembly& coarse, const Progress& progress) const {
	constexpr double shareOfCoarse = 0.4; // of the time
	const Positions coarseStart = coarse.assembly.originalPositions +
								  (start - assembly.originalPositions)(Eigen::all, coarse.wholePlace);
	LevelOutcome outcome = solve(coarse.assembly, coarseStart, partOf(progress, 0, shareOfCoarse));
	const Progress rest = partOf(progress, shareOfCoarse, 1);
	if (outcome.ending == BoundedEnding::Stopped)
		return outcome;
	const Positions moved =
		assembly.originalPositions +
		carriedOver(assembly, coarse, outcome.positions - coarse.assembly.originalPositions);
	const bool usable = outcome.ending == BoundedEnding::Within && TriangleOrder(assembly).holds(moved);
	LevelOutcome result = usable ? continueFrom(assembly, moved, hardStart, rest)
								 : continueFrom(assembly, start, softStart, rest);
	result.iterations += outcome.iterations;
	return result;
}

LevelOutcome BoundedLevels::continueFrom(const PatchAssembly& assembly, const Positions& start,
										 double stiffness, const Progress& progress) const {
	const FlatPatterns patterns = flattenPatches(assembly, start, {}, partOf(progress, 0, 0.05));
	if (patterns.report.stopped)
		return {BoundedEnding::Stopped, 0, start};
	const Progress ofRun = partOf(progress, 0.05, 1);
	BoundedRun run(assembly, patterns, start, options_, farthest_, bending_, stiffness, ofRun);
	const BoundedEnding ending = run.run();
	return {ending, run.iterations(), run.shape()};
}

} // namespace developable::detail
