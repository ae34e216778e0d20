// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_part.cpp: coarse levels first, then refinement, then what the pattern says of it.
#include "bounded_part.h"

#include "bounded_run.h"

#include <algorithm>
#include <utility>

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
	BoundedLevels(const BoundedStrainOptions& options, double farthest, const BendingLimit& bending)
		: options_(options), farthest_(farthest), bending_(bending) {}

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
		BoundedRun run(assembly, patterns, start, options_, farthest_, bending_, stiffness, ofRun);
		const BoundedEnding ending = run.run();
		return {ending, run.iterations(), run.shape()};
	}

	const BoundedStrainOptions& options_;
	const double farthest_;
	const BendingLimit bending_;
};

FlattenOptions flattening(const BoundedStrainOptions& options, bool onlyWithin) {
	FlattenOptions result;
	result.onlyWithin = onlyWithin;
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
/// \param onlyWithin  see FlattenOptions
bool measure(const PatchAssembly& part, const BoundedStrainOptions& options, bool onlyWithin,
			 const Progress& progress, BoundedOutcome& outcome) {
	outcome.patterns = flattenPatches(part, outcome.positions, flattening(options, onlyWithin), progress);
	if (outcome.patterns.report.stopped) {
		outcome.status = Status::Stopped;
		return false;
	}
	outcome.beyondBounds = beyondBounds(part, outcome.positions, outcome.patterns);
	return true;
}

bool within(const BoundedOutcome& outcome) {
	return outcome.beyondBounds.maxCoeff() <= patternTolerance;
}

/// From a start beyond the bounds.
BoundedOutcome solveFrom(const PatchAssembly& part, const Positions& start,
						 const BoundedStrainOptions& options, double farthest, const BendingLimit& bending,
						 const Progress& progress) {
	LevelOutcome found =
		BoundedLevels(options, farthest, bending).solve(part, start, partOf(progress, 0, 0.95));
	BoundedOutcome result;
	result.status = statusOf(found.ending, part);
	result.iterations = found.iterations;
	result.positions = std::move(found.positions);
	// A pattern by itself is found more exactly than together with its shape: it decides.
	if (result.status == Status::Stopped || !measure(part, options, false, partOf(progress, 0.95, 1), result))
		return result;
	if (within(result))
		result.status = Status::Converged;
	else if (result.status == Status::Converged)
		result.status = statusOf(BoundedEnding::Stuck, part);
	return result;
}

double shareBentTooTightly(const PatchAssembly& part, const Positions& positions, double leastRadius) {
	return leastRadius > 0 ? shareBelowRadius(part, positions, bendingRadii(part, positions), leastRadius)
						   : 0;
}

/// From a shape within the bounds that is bent too tightly in places: another one within them, and bent so in
/// fewer. What the shape is to be near stays the original. Where strains do not let it go all the way, it is
/// asked for with less force.
BoundedOutcome lessBent(const PatchAssembly& part, const BoundedStrainOptions& options, double farthest,
						BoundedOutcome best, const Progress& progress) {
	constexpr double forces[] = {0.1, 0.01, 0.001}; // the first moves a sheet by a good part of its size
	constexpr int mostSteps = 60;
	double least = shareBentTooTightly(part, best.positions, options.leastRadius);
	BoundedStrainOptions shorter = options;
	shorter.maxIterations = std::min(options.maxIterations, mostSteps);
	double done = 0;
	for (const double force : forces) {
		if (least == 0)
			break;
		BoundedOutcome next = solveFrom(part, part.originalPositions, shorter, farthest,
										{options.leastRadius, force}, partOf(progress, done, done + 1.0 / 3));
		done += 1.0 / 3;
		best.iterations += next.iterations;
		if (next.status == Status::Stopped) {
			best.status = Status::Stopped;
			return best;
		}
		const double share = shareBentTooTightly(part, next.positions, options.leastRadius);
		if (next.status != Status::Converged || share >= least)
			continue;
		next.iterations = best.iterations;
		best = std::move(next);
		break;
	}
	return best;
}

} // namespace

BoundedOutcome solveBounded(const PatchAssembly& part, const Positions& start,
							const BoundedStrainOptions& options, const Progress& progress) {
	const double farthest = farthestAllowed(part, options.maxDisplacement);
	BoundedOutcome result;
	result.positions = farthestMove(part, start) <= farthest ? start : part.originalPositions;
	if (!measure(part, options, farthest > 0, partOf(progress, 0, 0.05), result))
		return result;
	if (!within(result)) {
		if (farthest > 0)
			result = solveFrom(part, result.positions, options, farthest, {}, partOf(progress, 0.05, 0.5));
		else
			result.status = statusOf(BoundedEnding::Stuck, part);
	}
	if (result.status == Status::Stopped)
		return result;
	if (within(result))
		return farthest > 0 ? lessBent(part, options, farthest, std::move(result), partOf(progress, 0.5, 1))
							: result;
	if (!options.searchBeyond || (result.status != Status::NeedsCut && result.status != Status::Stalled))
		return result;
	const double anywhere = 10 * boxDiagonal(part.originalPositions);
	const BoundedOutcome free =
		solveFrom(part, part.originalPositions, options, anywhere, {}, partOf(progress, 0.7, 1));
	if (free.status == Status::Stopped)
		result.status = Status::Stopped;
	else if (free.status == Status::Converged && farthestMove(part, free.positions) > farthest)
		result.nearestDevelopable = farthestMove(part, free.positions);
	return result;
}

} // namespace developable::detail
