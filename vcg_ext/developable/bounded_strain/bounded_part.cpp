// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_part.cpp: coarse levels first, then refinement, then what the pattern says of it.
#include "bounded_part.h"

#include "bounded_run.h"

namespace developable::detail {

namespace {

constexpr int coarsest = 2500;         ///< places; so few are solved directly
constexpr int levelRatio = 4;          ///< between the numbers of places of two levels
constexpr double leastReduction = 0.6; ///< of places, for a coarse level that is worth its while
constexpr double softStart = 0.1;      ///< κ where a run begins from the original
constexpr double hardStart = 100;      ///< and from a coarser level's result

struct LevelOutcome {
	BoundedEnding ending = BoundedEnding::Stuck;
	int iterations = 0;
	Positions positions;
};

class BoundedLevels {
public:
	BoundedLevels(const BoundedStrainOptions& options, double farthest)
		: options_(options), farthest_(farthest) {}

	LevelOutcome solve(const PatchAssembly& assembly, const Positions& start,
					   const Progress& progress) const {
		if (assembly.placeCount() > coarsest) {
			const PartialAssembly coarse = coarserLevel(assembly, assembly.placeCount() / levelRatio);
			if (coarse.assembly.placeCount() < leastReduction * assembly.placeCount())
				return refine(assembly, start, coarse, progress);
		}
		return solveLevel(assembly, start, softStart, progress);
	}

private:
	LevelOutcome refine(const PatchAssembly& assembly, const Positions& start, const PartialAssembly& coarse,
						const Progress& progress) const {
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
		LevelOutcome result = usable ? solveLevel(assembly, moved, hardStart, rest)
									 : solveLevel(assembly, start, softStart, rest);
		result.iterations += outcome.iterations;
		return result;
	}

	LevelOutcome solveLevel(const PatchAssembly& assembly, const Positions& start, double stiffness,
							const Progress& progress) const {
		const FlatPatterns patterns = flattenPatches(assembly, start, {}, partOf(progress, 0, 0.05));
		if (patterns.report.stopped)
			return {BoundedEnding::Stopped, 0, start};
		const Progress ofRun = partOf(progress, 0.05, 1);
		BoundedRun run(assembly, patterns, start, options_, farthest_, stiffness, ofRun);
		const BoundedEnding ending = run.run();
		return {ending, run.iterations(), run.shape()};
	}

	const BoundedStrainOptions& options_;
	const double farthest_;
};

FlattenOptions flattening(const BoundedStrainOptions& options) {
	FlattenOptions result;
	result.bounds = options.bounds;
	result.grain = options.grain;
	return result;
}

Status statusOf(BoundedEnding ending, const PatchAssembly& part) {
	switch (ending) {
	case BoundedEnding::Within:
		return Status::Converged;
	case BoundedEnding::Stuck:
		return holdsPlaces(part) ? Status::Stalled : Status::NeedsCut;
	case BoundedEnding::OutOfSteps:
		return Status::LimitReached;
	case BoundedEnding::Stopped:
		return Status::Stopped;
	}
	return Status::Stalled;
}

/// Measures a result's pattern. \return false when the user asked for a stop
bool measure(const PatchAssembly& part, const BoundedStrainOptions& options, const Progress& progress,
			 BoundedOutcome& outcome) {
	const FlatPatterns patterns = flattenPatches(part, outcome.positions, flattening(options), progress);
	if (patterns.report.stopped) {
		outcome.status = Status::Stopped;
		return false;
	}
	outcome.beyondBounds = beyondBounds(part, outcome.positions, patterns);
	return true;
}

bool within(const BoundedOutcome& outcome) {
	return outcome.beyondBounds.maxCoeff() <= patternTolerance;
}

/// From a start beyond the bounds.
BoundedOutcome solveFrom(const PatchAssembly& part, const Positions& start,
						 const BoundedStrainOptions& options, double farthest, const Progress& progress) {
	LevelOutcome found = BoundedLevels(options, farthest).solve(part, start, partOf(progress, 0, 0.95));
	BoundedOutcome result;
	result.status = statusOf(found.ending, part);
	result.iterations = found.iterations;
	result.positions = std::move(found.positions);
	// A pattern by itself is found more exactly than together with its shape: it decides.
	if (result.status == Status::Stopped || !measure(part, options, partOf(progress, 0.95, 1), result))
		return result;
	if (within(result))
		result.status = Status::Converged;
	else if (result.status == Status::Converged)
		result.status = statusOf(BoundedEnding::Stuck, part);
	return result;
}

} // namespace

BoundedOutcome solveBounded(const PatchAssembly& part, const Positions& start,
							const BoundedStrainOptions& options, const Progress& progress) {
	const double farthest = farthestAllowed(part, options.maxDisplacement);
	BoundedOutcome result;
	result.positions = farthestMove(part, start) <= farthest ? start : part.originalPositions;
	if (!measure(part, options, partOf(progress, 0, 0.05), result) || within(result))
		return result;
	if (farthest > 0)
		result = solveFrom(part, result.positions, options, farthest, partOf(progress, 0.05, 0.7));
	else
		result.status = statusOf(BoundedEnding::Stuck, part);
	if (!options.searchBeyond || (result.status != Status::NeedsCut && result.status != Status::Stalled))
		return result;
	const double anywhere = 10 * boxDiagonal(part.originalPositions);
	const BoundedOutcome free =
		solveFrom(part, part.originalPositions, options, anywhere, partOf(progress, 0.7, 1));
	if (free.status == Status::Stopped)
		result.status = Status::Stopped;
	else if (free.status == Status::Converged && farthestMove(part, free.positions) > farthest)
		result.nearestDevelopable = farthestMove(part, free.positions);
	return result;
}

} // namespace developable::detail
