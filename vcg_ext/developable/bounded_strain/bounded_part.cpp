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
		const LevelOutcome outcome = solve(coarse.assembly, coarseStart, partOf(progress, 0, shareOfCoarse));
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

double farthestMove(const PatchAssembly& part, const Positions& positions) {
	return (positions - part.originalPositions).colwise().norm().maxCoeff();
}

/// How far the nearest shape within the bounds moves a place, were there no bound on that; 0: not found.
double nearestWithin(const PatchAssembly& part, const Positions& start, const BoundedStrainOptions& options,
					 double farthest, const Progress& progress) {
	const double anywhere = 10 * boxDiagonal(part.originalPositions);
	const LevelOutcome free = BoundedLevels(options, anywhere).solve(part, start, progress);
	const double move = farthestMove(part, free.positions);
	return free.ending == BoundedEnding::Within && move > farthest ? move : 0;
}

} // namespace

BoundedOutcome solveBounded(const PatchAssembly& part, const Positions& start,
							const BoundedStrainOptions& options, const Progress& progress) {
	const double farthest = farthestAllowed(part, options.maxDisplacement);
	BoundedOutcome result;
	result.positions = farthestMove(part, start) <= farthest ? start : part.originalPositions;
	const auto measure = [&] {
		const FlatPatterns patterns =
			flattenPatches(part, result.positions, flattening(options), partOf(progress, 0, 0.05));
		result.beyondBounds =
			patterns.report.stopped ? Eigen::VectorXd() : beyondBounds(part, result.positions, patterns);
		return patterns.report.stopped;
	};
	const auto within = [&] { return result.beyondBounds.maxCoeff() <= patternTolerance; };
	if (measure())
		result.status = Status::Stopped;
	if (result.status == Status::Stopped || within())
		return result;
	result.status = statusOf(BoundedEnding::Stuck, part);
	if (farthest > 0) {
		LevelOutcome outcome =
			BoundedLevels(options, farthest).solve(part, result.positions, partOf(progress, 0.05, 0.7));
		result.status = statusOf(outcome.ending, part);
		result.iterations = outcome.iterations;
		if (result.status == Status::Stopped)
			return result;
		result.positions = std::move(outcome.positions);
		// A pattern by itself is found more exactly than together with its shape.
		if (measure())
			result.status = Status::Stopped;
		else if (within())
			result.status = Status::Converged;
		else if (result.status == Status::Converged)
			result.status = statusOf(BoundedEnding::Stuck, part);
	}
	if (result.status == Status::NeedsCut || result.status == Status::Stalled)
		result.nearestDevelopable =
			nearestWithin(part, part.originalPositions, options, farthest, partOf(progress, 0.7, 1));
	return result;
}

} // namespace developable::detail
