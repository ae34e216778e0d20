// SPDX-License-Identifier: GPL-3.0-or-later
// newton_strategy.cpp: coarse levels first, then refinement.
#include "newton_strategy.h"

#include "closer_shapes.h"
#include "coarsening.h"
#include "displacement_metric.h"
#include "fair_descent.h"
#include "fair_shape.h"
#include "normal_steps.h"
#include "pull_back.h"
#include "refinement.h"
#include "shortest_steps.h"
#include "without_detail.h"

#include <chrono>

namespace developable::detail {

namespace {

constexpr double growth = 1.2; ///< time goes with this power of the number of places

/// How many a coarser level is to have.
int coarserPlaces(int places, int coarsest, const NewtonTuning& tuning) {
	const int coarser = static_cast<int>(places / tuning.levelRatio);
	return tuning.isCoarsest(coarser, coarsest) ? coarsest : coarser;
}

/// What a part of so many places takes on all its levels, as far as one can tell before; in units of
/// WorkBudget: most of it on the coarsest, and steps along the normals on the others.
struct ExpectedWork {
	double coarsening = 0, onCoarser = 0, onFinest = 0;

	ExpectedWork(int places, int coarsest, const NewtonTuning& tuning) {
		constexpr double ofCoarsest = 900, ofFiner = 100, ofCoarsening = 20; // a place
		const bool isLast = tuning.isCoarsest(places, coarsest);
		onFinest = (isLast ? ofCoarsest : ofFiner) * places;
		if (isLast)
			return;
		coarsening = ofCoarsening * places;
		onCoarser = ExpectedWork(coarserPlaces(places, coarsest, tuning), coarsest, tuning).whole();
	}
	double whole() const { return coarsening + onCoarser + onFinest; }
};

/// What is about to be done, and how long it may take.
std::string announce(const PatchAssembly& assembly, double seconds) {
	const std::string size = std::to_string(assembly.placeCount()) + " vertices";
	if (seconds < 2)
		return size + ": ";
	if (seconds < 100)
		return size + ", about " + std::to_string(std::lround(seconds)) + " s: ";
	return size + ", about " + std::to_string(std::lround(seconds / 60)) + " min: ";
}

bool isLessCurved(const PatchAssembly& assembly, const Positions& shape, const Positions& other) {
	return lessCurved(assembly, flatDefects(assembly, shape), flatDefects(assembly, other));
}

} // namespace

NewtonStrategy::NewtonStrategy(double smoothness, double fairness, const CurvatureGoal& goal,
							   int maxIterations, double memoryLimit, const NewtonTuning& tuning)
	: smoothness_(smoothness), shapeSmoothness_(shapeSmoothness(fairness)), goal_(goal),
	  maxIterations_(maxIterations), memoryLimit_(memoryLimit), tuning_(tuning) {}

void NewtonStrategy::beginNearFairShape(double fairness) {
	shapeSmoothness_ = shapeSmoothness(fairness);
	tuning_.fairSteps = 1;
	leftToOthers_.fairness = true;
}

/// With less room to move, for what the finest level adds. Where that is large enough for local steps, so are
/// all levels: the nearer these end, the better it begins.
NewtonStrategy NewtonStrategy::coarser(const Level& level) const {
	NewtonStrategy result = *this;
	if (!leftToOthers_.finestLevel) {
		if (isWithoutDetail(level))
			result.tuning_.preferredLength =
				preferredMove(level.assembly, tuning_, goal_) - roomOfDetail(level.assembly, *level.fair);
		result.goal_.farthest *= tuning_.coarseRoom;
		result.tuning_.preferredMove *= tuning_.coarseRoom;
		result.tuning_.preferredLength *= tuning_.coarseRoom;
		result.tuning_.localRows = tuning_.coarseLocalRows;
	}
	result.tuning_.localPlaces = static_cast<int>(tuning_.localPlaces / tuning_.levelRatio);
	result.leftToOthers_.finestLevel = true;
	result.leftToOthers_.fairness = leftToOthers_.fairness || descends(level);
	return result;
}

NewtonOutcome NewtonStrategy::solve(const PatchAssembly& assembly, const Positions& start,
									const Progress& progress) const {
	Level finest = levelOf(assembly, 1);
	if (!finest.fair) {
		NewtonOutcome outcome = solveNear(finest, start, progress);
		if (outcome.ending != Ending::Stuck)
			return outcome;
		leaveDetail(finest);
	}
	NewtonOutcome outcome = solveLevel(finest, start, progress);
	if (outcome.ending != Ending::Stuck || !outcome.bordersLimited)
		return outcome;
	// What the coarse levels could do without kinks the finest may not.
	NewtonStrategy free = *this;
	free.tuning_.limitedSteps = 0;
	return free.solveLevel(finest, start, progress);
}

/// What is all but developable needs neither coarser levels nor a continuation.
NewtonOutcome NewtonStrategy::solveNear(const Level& level, const Positions& start,
										const Progress& progress) const {
	const std::unique_ptr<NewtonProblem> problem = problemOf(level, tuning_);
	problem->jacobian().freeBorders(true);
	NewtonRun shortest(*problem, start, maxIterations_, progress);
	const double most = tuning_.nearCurvature * goal_.curvatureTolerance;
	const bool near = shortest.startCurvature() < most;
	const Ending ending = ShortestSteps(*problem, shortest).run();
	if (ending != Ending::Stuck || !near)
		return {ending, shortest.iterations(), shortest.shape().positions};
	problem->setSmoothness(smoothness_);
	constexpr double shareBefore = 0.05; // of the time
	const Progress before = partOf(progress, 0, shareBefore);
	NewtonRun run(*problem, start, std::min(maxIterations_, tuning_.nearSteps), before);
	const double farthest = std::min(goal_.farthest, tuning_.nearMove * problem->diagonal());
	const Ending along = NormalSteps(*problem, run, farthest).run();
	return {along == Ending::OutOfSteps ? Ending::Stuck : along, run.iterations(), run.shape().positions};
}

void NewtonStrategy::leaveDetail(Level& level) const {
	const PatchAssembly& assembly = level.assembly;
	if (!assembly.isSewn() || tuning_.isCoarsest(assembly.placeCount(), tuning_.fewestTogether()))
		return;
	level.fair = withoutDetail(assembly, preferredMove(assembly, tuning_, goal_), tuning_, memoryLimit_);
}

NewtonStrategy::Level NewtonStrategy::levelOf(const PatchAssembly& assembly, double coarseness) const {
	Level level{assembly, coarseness, {}};
	if (shapeSmoothness_ > 0)
		level.fair = fairShape(unfairnessOf(assembly), goal_, tuning_);
	return level;
}

Unfairness NewtonStrategy::unfairnessOf(const PatchAssembly& assembly) const {
	return {assembly, shapeSmoothness_, tuning_, memoryLimit_};
}

/// A border may turn at one vertex by so much more as edges are longer.
std::unique_ptr<NewtonProblem> NewtonStrategy::problemOf(const Level& level, NewtonTuning tuning) const {
	tuning.borderTurn *= level.coarseness;
	auto problem = std::make_unique<NewtonProblem>(level.assembly, level.reference(), goal_, tuning,
												   memoryLimit_, shapeSmoothness_);
	problem->setBudget(budget_);
	return problem;
}

std::unique_ptr<NewtonProblem> NewtonStrategy::fineProblemOf(const Level& level) const {
	std::unique_ptr<NewtonProblem> problem =
		problemOf(level, leftToOthers_.waysBack ? tuning_.beforeOthers() : tuning_);
	// What has to go there are short waves, and long ones in their stead lead panels far away that pull at
	// each other. A single panel stays smoother with all of α, and what is large takes a third of the time.
	const bool mayReturn = level.assembly.isSewn() && isSmallEnoughToReturn(*problem);
	problem->setSmoothness(mayReturn ? tuning_.fineSmoothness * smoothness_ : smoothness_);
	problem->jacobian().freeBorders(true);
	return problem;
}

bool NewtonStrategy::descends(const Level& level) const {
	return isNearFairShape() && !leftToOthers_.fairness && level.assembly.placeCount() <= tuning_.fairPlaces;
}

NewtonOutcome NewtonStrategy::solveLevel(const Level& level, const Positions& start,
										 const Progress& progress) const {
	constexpr double shareBefore = 0.2; // of the time
	if (!descends(level))
		return solveByCoarser(level, start, progress);
	NewtonOutcome outcome = solveByCoarser(level, start, partOf(progress, 0, shareBefore));
	if (outcome.ending != Ending::Reached)
		return outcome;
	const Unfairness unfairness = unfairnessOf(level.assembly);
	FairDescent descent(unfairness, smoothness_, goal_, maxIterations_, memoryLimit_, tuning_, budget_);
	outcome.ending = descent.run(outcome.positions, partOf(progress, shareBefore, 1));
	outcome.iterations += descent.iterations();
	return outcome;
}

NewtonOutcome NewtonStrategy::solveByCoarser(const Level& level, const Positions& start,
											 const Progress& progress) const {
	const PatchAssembly& assembly = level.assembly;
	const int places = assembly.placeCount();
	const int coarsest = assembly.isSewn() ? tuning_.fewestTogether() : tuning_.coarsest;
	if (tuning_.isCoarsest(places, coarsest))
		return solveCoarsest(level, start, progress);
	const PatchAssembly& shape = isWithoutDetail(level) ? level.reference() : assembly;
	const PartialAssembly coarse =
		Coarsening(shape, tuning_).coarsen(coarserPlaces(places, coarsest, tuning_));
	if (coarse.assembly.placeCount() > tuning_.leastReduction * places)
		return solveCoarsest(level, start, progress);
	const double sizes = double(places) / coarse.assembly.placeCount();
	const Level coarseLevel = levelOf(coarse.assembly, level.coarseness * std::sqrt(sizes));

	const ExpectedWork work(places, coarsest, tuning_);
	const double coarseBegin = work.coarsening / work.whole();
	const double coarseEnd = coarseBegin + work.onCoarser / work.whole();
	const auto begin = std::chrono::steady_clock::now();
	const Positions coarseStart = coarse.assembly.originalPositions +
								  (start - assembly.originalPositions)(Eigen::all, coarse.wholePlace);
	NewtonOutcome coarseOutcome;
	std::optional<WorkReserve> reserve(std::in_place, *budget_, tuning_.reserveOfCoarse);
	Refinement refinement(assembly, coarse, tuning_, memoryLimit_, [&] { return fineProblemOf(level); });
	refinement.prepareBeside([&] {
		coarseOutcome =
			coarser(level).solveLevel(coarseLevel, coarseStart, partOf(progress, coarseBegin, coarseEnd));
	});
	reserve.reset();
	if (coarseOutcome.ending == Ending::Stopped || coarseOutcome.ending == Ending::TooFar) {
		coarseOutcome.positions = start;
		return coarseOutcome;
	}
	const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
	const std::string announcement = announce(assembly, taken.count() * std::pow(sizes, growth));
	const bool developable = coarseOutcome.ending == Ending::Reached;
	CoarseShape solved = {developable, farthestMove(coarse.assembly, coarseOutcome.positions), {}, {}};
	const Positions& reference = level.reference().originalPositions;
	if (isSmallEnoughToReturn(refinement.problem()))
		solved.smoothing = refinement.smoothing(reference);
	solved.displacement =
		refinement.prolonged(coarseOutcome.positions - coarseLevel.reference().originalPositions) +
		reference - assembly.originalPositions;
	return refine(refinement.problem(), solved, coarseOutcome, partOf(progress, coarseEnd, 1, announcement));
}

NewtonOutcome NewtonStrategy::solveCoarsest(const Level& level, const Positions& start,
											const Progress& progress) const {
	const std::unique_ptr<NewtonProblem> problem = problemOf(level, tuning_);
	NewtonOutcome outcome = attemptFrom(*problem, start, smoothness_, maxIterations_, progress);
	if (outcome.ending == Ending::Reached && leftToOthers_.finestLevel && level.assembly.isSewn()) {
		problem->setSmoothness(smoothness_);
		problem->jacobian().freeBorders(!outcome.bordersLimited);
		comeCloser(*problem, maxIterations_, outcome, progress);
	}
	const bool tooFar = outcome.nearestDevelopable > 0;
	const bool hemmedIn = tooFar || holdsPlaces(level.assembly);
	const bool wanted = tuning_.leastSquares > 0 && (hemmedIn || !budget_->spent());
	if (outcome.ending != Ending::Stuck || !wanted)
		return outcome;
	const int few = std::min(maxIterations_, tuning_.leastSquaresSteps);
	const int steps = hemmedIn ? std::max(few, maxIterations_ - outcome.iterations) : few;
	goOnToLeastSquares(*problem, Positions(outcome.positions), steps, outcome, progress);
	// The least curved may be where borders had to heed limits and the bound at once: a bad start.
	if (tooFar && outcome.ending == Ending::Stuck)
		goOnToLeastSquares(*problem, Positions(outcome.free), steps, outcome, progress);
	return outcome;
}

/// Where there is no way to g = 0, steps along the normals go on to the least squares of it.
void NewtonStrategy::goOnToLeastSquares(NewtonProblem& problem, const Positions& from, int steps,
										NewtonOutcome& outcome, const Progress& progress) const {
	const PatchAssembly& assembly = problem.assembly();
	problem.setSmoothness(smoothness_);
	problem.jacobian().freeBorders(true);
	NewtonRun run(problem, from, steps, progress);
	const Ending ending = NormalSteps(problem, run, problem.goal().farthest).run();
	outcome.iterations += run.iterations();
	if (isLessCurved(assembly, run.shape().positions, outcome.positions))
		outcome.positions = run.shape().positions;
	// Least squares are approached slowly: to run out of steps there is no more than to be stuck.
	if (ending != Ending::OutOfSteps)
		outcome.ending = ending;
}

NewtonOutcome NewtonStrategy::refine(NewtonProblem& problem, const CoarseShape& shape,
									 const NewtonOutcome& coarse, const Progress& progress) const {
	NewtonOutcome outcome = solveFine(problem, shape, maxIterations_, progress);
	outcome.nearestDevelopable = coarse.nearestDevelopable;
	outcome.bordersLimited = coarse.bordersLimited;
	if (outcome.ending != Ending::Stuck || !shape.developable)
		return outcome;
	problem.forgetNormalSystem();
	const AttemptResult restored =
		restoreFrom(problem, outcome.positions, smoothness_, maxIterations_ - outcome.iterations, progress);
	outcome.ending = restored.ending;
	outcome.iterations += restored.iterations;
	if (restored.ending == Ending::Reached ||
		isLessCurved(problem.assembly(), restored.positions, outcome.positions))
		outcome.positions = restored.positions;
	return outcome;
}

} // namespace developable::detail
