// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_part.cpp: runs from one start or from several, and what the pattern says of their results.
#include "bounded_part.h"

#include "bounded_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace developable::detail {

namespace {

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
	case BoundedEnding::TooFar:
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

/// A pattern by itself is found more exactly than together with its shape: it decides.
BoundedOutcome judged(const PatchAssembly& part, LevelOutcome found, const BoundedStrainOptions& options,
					  const Progress& progress) {
	BoundedOutcome result;
	result.status = statusOf(found.ending, part);
	result.iterations = found.iterations;
	result.positions = std::move(found.positions);
	const bool onlyWithin = found.ending == BoundedEnding::TooFar;
	if (result.status == Status::Stopped || !measure(part, options, onlyWithin, progress, result))
		return result;
	if (within(result))
		result.status = Status::Converged;
	else if (result.status == Status::Converged)
		result.status = statusOf(BoundedEnding::Stuck, part);
	return result;
}

/// From a start beyond the bounds.
BoundedOutcome solveFrom(const PatchAssembly& part, const Positions& start,
						 const BoundedStrainOptions& options, double farthest, const BendingLimit& bending,
						 const Progress& progress) {
	const BoundedLevels levels(options, farthest, bending);
	return judged(part, levels.solve(part, start, partOf(progress, 0, 0.95)), options,
				  partOf(progress, 0.95, 1));
}

/// Of a part so small its time hardly counts.
bool ofFewPlaces(const PatchAssembly& part) {
	constexpr int fewPlaces = 500;
	return part.placeCount() <= fewPlaces;
}

/// At which waves shorter than so many edges are dear: of 2π α^¼ √A, where a patch of the area A has as many
/// vertices as squares on an edge.
double smoothnessOfWaves(double edges, const PatchAssembly& part) {
	const double verticesOfPatch = part.triangleCount() / (2.0 * part.patchCount());
	return std::min(std::pow(edges / (2 * pi), 4) / (verticesOfPatch * verticesOfPatch), 1.0);
}

/// The nearest result of several runs.
class NearestOfRuns {
public:
	NearestOfRuns(const PatchAssembly& part, const BoundedStrainOptions& options, double farthest,
				  BoundedOutcome first)
		: part_(part), options_(options), levels_(options, farthest, {}), farthest_(farthest),
		  near_(nearness(part, options.smoothness, options.fairness)), best_(std::move(first)) {}

	bool stopped() const { return best_.status == Status::Stopped; }
	const BoundedOutcome& best() const { return best_; }

	/// By way of the shape that is nearest at another smoothness.
	void by(double smoothness, const Positions& start, const Progress& progress) {
		BoundedStrainOptions first = options_;
		first.smoothness = smoothness;
		const LevelOutcome way =
			BoundedLevels(first, farthest_, {}).solve(part_, start, partOf(progress, 0, 0.6));
		best_.iterations += way.iterations;
		if (way.ending == BoundedEnding::Stopped)
			best_.status = Status::Stopped;
		else
			goOn(way.positions, hard, partOf(progress, 0.6, 1));
	}

	/// From the best result once more. \return whether that was worth its while
	bool again(const Progress& progress) {
		constexpr double worthwhile = 0.98; // of the squared distance
		const double before = near_.squaredDistance(best_.positions);
		if (best_.status == Status::Converged)
			goOn(Positions(best_.positions), halfSoft, progress);
		return near_.squaredDistance(best_.positions) < worthwhile * before;
	}

private:
	static constexpr double hard = 100;   // κ that keeps the waves of a start
	static constexpr double halfSoft = 1; // and with which they may move

	void goOn(const Positions& start, double stiffness, const Progress& progress) {
		BoundedOutcome next =
			judged(part_, levels_.continueFrom(part_, start, stiffness, partOf(progress, 0, 0.9)), options_,
				   partOf(progress, 0.9, 1));
		best_.iterations += next.iterations;
		if (next.status == Status::Stopped)
			best_.status = Status::Stopped;
		if (next.status != Status::Converged ||
			(best_.status == Status::Converged &&
			 near_.squaredDistance(next.positions) >= near_.squaredDistance(best_.positions)))
			return;
		next.iterations = best_.iterations;
		best_ = std::move(next);
	}

	const PatchAssembly& part_;
	const BoundedStrainOptions& options_;
	const BoundedLevels levels_;
	const double farthest_;
	const Nearness near_;
	BoundedOutcome best_;
};

/// From a start beyond the bounds, by several runs for small parts: of the many rows of waves that may take
/// up what strain is too much, soft bounds first lead to one, and there may be nearer ones. Where the mesh
/// has room for many waves of the asked smoothness, or it is large, the first run is nearly as good as the
/// others.
BoundedOutcome nearestFrom(const PatchAssembly& part, const Positions& start,
						   const BoundedStrainOptions& options, double farthest, const Progress& progress) {
	constexpr int mostTimes = 4;
	constexpr double waves[] = {2, 4, 8};                 // edges
	constexpr double first = 0.2, way = 0.2, more = 0.05; // shares of the time
	const bool several = options.severalStarts && ofFewPlaces(part);
	BoundedOutcome direct =
		solveFrom(part, start, options, farthest, {}, partOf(progress, 0, several ? first : 1));
	if (!several || direct.status == Status::Stopped || direct.status == Status::LimitReached)
		return direct;
	NearestOfRuns runs(part, options, farthest, std::move(direct));
	double done = first;
	const auto next = [&](double share) {
		done += share;
		return partOf(progress, done - share, std::min(done, 1.0));
	};
	for (const double edges : waves)
		if (!runs.stopped())
			runs.by(smoothnessOfWaves(edges, part), start, next(way));
	for (int i = 0; i < mostTimes && !runs.stopped() && runs.again(next(more)); ++i) {
	}
	return runs.best();
}

/// From the original, where no shape within the largest displacement was found: the one that would be found
/// without asking for less than the usual one, or any.
BoundedOutcome nearestAnywhere(const PatchAssembly& part, const BoundedStrainOptions& options,
							   double farthest, const Progress& progress) {
	const double usual = farthestAllowed(part, -1), anywhere = 10 * boxDiagonal(part.originalPositions);
	BoundedOutcome found;
	if (farthest < usual && ofFewPlaces(part)) // in large parts that limit makes no difference
		found = nearestFrom(part, part.originalPositions, options, usual, partOf(progress, 0, 0.5));
	if (found.status != Status::Stopped && found.status != Status::Converged)
		found = solveFrom(part, part.originalPositions, options, anywhere, {}, partOf(progress, 0.5, 1));
	return found;
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
			result = nearestFrom(part, result.positions, options, farthest, partOf(progress, 0.05, 0.5));
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
	const BoundedOutcome free = nearestAnywhere(part, options, farthest, partOf(progress, 0.7, 1));
	if (free.status == Status::Stopped)
		result.status = Status::Stopped;
	else if (free.status == Status::Converged && farthestMove(part, free.positions) > farthest)
		result.nearestDevelopable = farthestMove(part, free.positions);
	return result;
}

} // namespace developable::detail
