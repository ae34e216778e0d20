// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.cpp: continuation, restoration, and the way back within the bound on displacements.
#include "newton_attempt.h"

#include "continuation.h"
#include "displacement_metric.h"
#include "pull_back.h"
#include "restoration.h"
#include "return_within_bound.h"

namespace developable::detail {

namespace {

/// The same shape with next to nothing added along its normals, a wave round the place farthest from the
/// middle. A symmetric shape has as many ways to become developable as it has symmetries; rounding would
/// choose between them, late and differently for every order of the vertices.
Positions withoutSymmetry(const NewtonProblem& problem, const Positions& start) {
	int farthest = 0;
	(start.colwise() - start.rowwise().mean()).colwise().squaredNorm().maxCoeff(&farthest);
	const Eigen::RowVectorXd distances =
		(start.colwise() - Eigen::Vector3d(start.col(farthest))).colwise().norm();
	const Eigen::RowVectorXd wave =
		problem.tuning().symmetryBreaking * problem.diagonal() *
		(problem.tuning().symmetryWaves * 2 * pi / problem.diagonal() * distances).array().cos();
	Positions moved = start + placeNormals(problem.assembly(), start) * wave.asDiagonal();
	for (int place = 0; place < moved.cols(); ++place)
		if (problem.assembly().placeFixed[place])
			moved.col(place) = start.col(place);
	return problem.soundness().holds(moved) ? moved : start;
}

bool cameNear(const NewtonProblem& problem, const NewtonRun& run) {
	return run.shape().curvature < problem.tuning().nearlyThere * run.startCurvature();
}

/// A restoration that leads no further: borders may turn as they like now, and triangles that are in the way
/// are made stiffer.
Ending restoreMoreFreely(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double epsilon) {
	problem.jacobian().freeBorders(true);
	run.goBackTo(problem.shapeAt(run.shape().positions)); // limits on borders no longer count in its defects
	steps.beginToStiffen();
	return Restoration(problem, run, steps, epsilon).restore();
}

/// A continuation and, where that has not reached g = 0 by itself, a restoration.
/// \param heavyFrom  see Continuation::makeFarPlacesHeavy; 0: none are
Ending approach(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, double heavyFrom = 0) {
	Continuation continuation(problem, run, steps);
	continuation.makeFarPlacesHeavy(heavyFrom);
	const Ending ending = continuation.follow();
	if (ending != Ending::Settled && ending != Ending::Stuck)
		return ending;
	const Ending restored = Restoration(problem, run, steps, continuation.epsilon()).restore();
	// Where places are held, what is looked for is the least squares of g.
	const bool goesOn =
		!holdsPlaces(problem.assembly()) && !problem.metric().tooStiff() && cameNear(problem, run);
	if (restored != Ending::Stuck || !goesOn)
		return restored;
	return restoreMoreFreely(problem, run, steps, continuation.epsilon());
}

/// A developable shape that is farther away than places may go is none that was looked for, but there may be
/// one near it that is.
/// \param begin    of the attempt
/// \param nearest  becomes how far the nearest developable shape moves a place, where that is too far
Ending withinBound(Ending ending, NewtonProblem& problem, NewtonRun& run, GaussNewton& steps,
				   const WorkBudget& begin, double& nearest) {
	if (!run.farOff())
		return ending == Ending::Reached ? withinPreferred(problem, run, steps, begin) : ending;
	ReturnWithinBound way(problem, run, steps, problem.goal().farthest);
	Ending ofReturn = way.run();
	if (ofReturn != Ending::Reached && ofReturn != Ending::Stopped)
		ofReturn = pullBackWithin(problem, run, problem.goal().farthest);
	if (ofReturn == Ending::Reached || ofReturn == Ending::Stopped)
		return ofReturn;
	nearest = way.found().farthest;
	goBackWithin(problem, run, problem.goal().farthest); // the best start of steps to the least squares of g
	return Ending::Stuck;
}

/// What leads from the start to where an attempt ends; may say more of it in the result.
using Way = std::function<Ending(NewtonRun&, GaussNewton&, AttemptResult&)>;

AttemptResult attemptOn(const Way& way, NewtonProblem& problem, const Positions& start,
						const AttemptSetting& setting, const Progress& progress) {
	problem.setSmoothness(setting.smoothness);
	problem.jacobian().freeBorders(!setting.limitsBorders);
	NewtonRun run(problem, withoutSymmetry(problem, start), setting.maxIterations, progress);
	GaussNewton steps(problem, run, setting.stiffens);
	AttemptResult result;
	result.ending = steps.unsolvable() ? Ending::Unsolvable : way(run, steps, result);
	result.metLimits = steps.metLimits();
	result.bordersLimited = !problem.jacobian().bordersFree();
	result.iterations = run.iterations();
	// Within a bound that is smaller than what breaks the symmetry there may have been no shape on the way.
	const bool near = farthestMove(problem.assembly(), run.nearest()) <= problem.goal().farthest;
	result.positions = near ? run.nearest() : start;
	return result;
}

AttemptResult plainAttempt(NewtonProblem& problem, const Positions& start, const AttemptSetting& setting,
						   const Progress& progress) {
	const WorkBudget begin = problem.budget();
	return attemptOn(
		[&](NewtonRun& run, GaussNewton& steps, AttemptResult& result) {
			const Ending ending = approach(problem, run, steps);
			result.cameNear = cameNear(problem, run);
			if (ending == Ending::Reached && !run.farOff())
				setting.nothingFollows();
			return withinBound(ending, problem, run, steps, begin, result.nearestDevelopable);
		},
		problem, start, setting, progress);
}

/// With far places heavy all the way. Panels that are sewn together pull at each other: the shape that is
/// nearest on average has places far away, and there are others without, hardly farther on average.
AttemptResult attemptWithinPreferred(NewtonProblem& problem, const Positions& start, AttemptSetting setting,
									 const Progress& progress) {
	const NewtonTuning& tuning = problem.tuning();
	const WorkBudget begin = problem.budget();
	const double bound = problem.preferredMove();
	setting.maxIterations = std::min(tuning.togetherSteps, setting.maxIterations / 2);
	return attemptOn(
		[&](NewtonRun& run, GaussNewton& steps, AttemptResult&) {
			const Ending ending = approach(problem, run, steps, bound);
			if (ending != Ending::Reached)
				return ending == Ending::Stopped ? ending : Ending::Stuck;
			if (run.farOff())
				return Ending::Stuck;
			setting.nothingFollows();
			return run.shape().farthest <= tuning.pullBackReach * bound
					   ? withinPreferred(problem, run, steps, begin)
					   : Ending::Reached;
		},
		problem, start, setting, progress);
}

/// Whether a developable shape is within how far a place had better move, or nearly, and near on average.
bool isNearEnough(const NewtonProblem& problem, const Positions& positions) {
	const NewtonTuning& tuning = problem.tuning();
	const Eigen::VectorXd shares =
		displacementMap(problem.assembly().originalPositions, positions) / problem.preferredMove();
	return shares.maxCoeff() <= 1 ||
		   (shares.maxCoeff() <= tuning.pullBackReach && shares.mean() <= tuning.togetherMean);
}

} // namespace

AttemptResult attempt(NewtonProblem& problem, const Positions& start, const AttemptSetting& setting,
					  const Progress& progress) {
	constexpr double shareWithin = 0.4; // of the time
	if (!problem.assembly().isSewn() || problem.preferredMove() == 0)
		return plainAttempt(problem, start, setting, progress);
	AttemptResult within = attemptWithinPreferred(problem, start, setting, partOf(progress, 0, shareWithin));
	const bool developable = within.ending == Ending::Reached;
	if (within.ending == Ending::Stopped || (developable && isNearEnough(problem, within.positions)))
		return within;
	if (problem.tuning().beyondPreferred == 0) {
		within.ending = Ending::TooFar;
		return within;
	}
	AttemptSetting left = setting;
	left.maxIterations -= within.iterations;
	AttemptResult plain = plainAttempt(problem, start, left, partOf(progress, shareWithin, 1));
	const bool better = !developable || plain.ending == Ending::Reached || plain.ending == Ending::Stopped;
	AttemptResult& result = better ? plain : within;
	result.iterations = within.iterations + plain.iterations;
	return std::move(result);
}

AttemptResult restoreFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress) {
	problem.setSmoothness(smoothness);
	problem.jacobian().freeBorders(true);
	NewtonRun run(problem, start, maxIterations, progress);
	GaussNewton steps(problem, run, true, problem.goal().farthest);
	Ending ending = Ending::Unsolvable;
	if (!steps.unsolvable()) {
		const double epsilon = Continuation(problem, run, steps).leastEpsilon();
		ending = Restoration(problem, run, steps, epsilon).restore();
		if (ending == Ending::Reached)
			ending = withinPreferred(problem, run, steps);
	}
	AttemptResult result;
	result.ending = ending;
	result.iterations = run.iterations();
	result.positions = run.nearest();
	return result;
}

} // namespace developable::detail
