// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.cpp: continuation and restoration, again and again.
#include "newton_attempt.h"

#include "continuation.h"
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
	const bool near = problem.shapeAt(moved).farthest <= problem.goal().farthest;
	return near && problem.soundness().holds(moved) ? moved : start;
}

/// A continuation and, where that has not reached g = 0 by itself, a restoration.
Ending approach(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps, Continuation& continuation) {
	const Ending ending = continuation.follow();
	if (ending != Ending::Settled && ending != Ending::Stuck)
		return ending;
	return Restoration(problem, run, steps, continuation.epsilon()).restore();
}

/// A developable shape with a place that moves a little farther than it had better: there may be one near it
/// that does without. \return Reached, with the shape as it was where that leads nowhere; Stopped
Ending withinPreferred(NewtonProblem& problem, NewtonRun& run, GaussNewton& steps) {
	const Shape found = run.shape();
	const double preferred = problem.preferredMove();
	const Ending pulledBack = pullBackWithinPreferred(problem, run);
	if (pulledBack != Ending::Stuck)
		return pulledBack;
	if (found.farthest > problem.tuning().preferredReach * preferred)
		return Ending::Reached;
	const Ending ending = ReturnWithinBound(problem, run, steps, preferred).run();
	if (ending == Ending::Stopped)
		return ending;
	if (ending != Ending::Reached || !problem.hardlyFarther(run.shape(), found))
		run.goBackTo(found);
	return Ending::Reached;
}

/// A developable shape that is farther away than places may go is none that was looked for, but there may be
/// one near it that is.
/// \param nearest  becomes how far the nearest developable shape moves a place, where that is too far
Ending withinBound(Ending ending, NewtonProblem& problem, NewtonRun& run, GaussNewton& steps,
				   double& nearest) {
	if (!run.farOff())
		return ending == Ending::Reached ? withinPreferred(problem, run, steps) : ending;
	const Ending pulledBack = pullBackWithin(problem, run, problem.goal().farthest);
	if (pulledBack != Ending::Stuck)
		return pulledBack;
	ReturnWithinBound way(problem, run, steps, problem.goal().farthest);
	const Ending ofReturn = way.run();
	if (ofReturn == Ending::Reached || ofReturn == Ending::Stopped)
		return ofReturn;
	nearest = nearest > 0 ? std::min(nearest, way.nearest()) : way.nearest();
	return Ending::Stuck;
}

/// From the start to a developable shape within the bound on displacements.
Ending attempt(NewtonProblem& problem, NewtonRun& run, bool stiffens, double& nearest) {
	GaussNewton steps(problem, run, stiffens);
	if (steps.unsolvable())
		return Ending::Unsolvable;
	Continuation continuation(problem, run, steps);
	const Ending ending = approach(problem, run, steps, continuation);
	return withinBound(ending, problem, run, steps, nearest);
}

constexpr double muchCurvature = 0.1; ///< share of C at the start: more left is far from developable

/// Triangles all over were in the way and much curvature is left: the shape itself needs a cut, and a
/// smoother displacement would not help it.
bool hopeless(const NewtonProblem& problem, const NewtonRun& run) {
	return problem.metric().tooStiff() && run.shape().curvature > muchCurvature * run.startCurvature();
}

Eigen::VectorXd sameForAll(const NewtonProblem& problem, double smoothness) {
	return Eigen::VectorXd::Constant(problem.assembly().patchCount(), smoothness);
}

/// What an attempt says, as its part of all: the first most often is the only one.
Progress progressOfAttempt(const Progress& progress, int attempt) {
	constexpr double left = 0.5; // of what is left, to the attempts behind
	const double begin = 1 - std::pow(left, attempt), end = 1 - std::pow(left, attempt + 1);
	return partOf(progress, begin, end);
}

/// The nearest developable shape whose borders don't kink, if that is soon found; else the start, stuck.
NewtonOutcome attemptWithLimits(NewtonProblem& problem, const Positions& start, double smoothness,
								int maxIterations, const Progress& progress) {
	const int steps = std::min(maxIterations, problem.tuning().limitedSteps);
	if (steps < maxIterations && steps == 0)
		return {Ending::Stuck, 0, start, smoothness};
	problem.setSmoothness(sameForAll(problem, smoothness));
	problem.jacobian().freeBorders(false);
	const Progress progressOfThis = progressOfAttempt(progress, 0);
	NewtonRun run(problem, withoutSymmetry(problem, start), steps, progressOfThis);
	double nearest = 0;
	Ending ending = attempt(problem, run, false, nearest);
	if (ending == Ending::OutOfSteps && steps < maxIterations)
		ending = Ending::Stuck;
	const bool moved = ending != Ending::Stuck && run.iterations() > 0;
	return {ending,     run.iterations(), moved ? run.nearest() : start,
			smoothness, nearest,          ending == Ending::Reached};
}

} // namespace

NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress) {
	const PatchAssembly& assembly = problem.assembly();
	const NewtonTuning& tuning = problem.tuning();
	Eigen::VectorXd smoothnesses = sameForAll(problem, smoothness);
	Eigen::VectorXd leastDefects = flatDefects(assembly, start);
	NewtonOutcome best = attemptWithLimits(problem, start, smoothness, maxIterations, progress);
	if (best.ending != Ending::Stuck)
		return best;
	problem.jacobian().freeBorders(true);
	for (int i = 0; i < tuning.attempts; ++i) {
		problem.setSmoothness(smoothnesses);
		const Progress progressOfThis = progressOfAttempt(progress, i + 1);
		NewtonRun run(problem, withoutSymmetry(problem, start), maxIterations - best.iterations,
					  progressOfThis);
		best.ending = attempt(problem, run, i > 0, best.nearestDevelopable);
		best.iterations += run.iterations();
		// The attempts before had ended by themselves, and stiffer triangles are what can't be solved for.
		const bool gaveUp = best.ending == Ending::OutOfSteps || best.ending == Ending::Unsolvable;
		if (gaveUp && (i > 0 || problem.budget().spent()))
			best.ending = Ending::Stuck;
		if (best.ending == Ending::Stopped)
			break;
		const Eigen::VectorXd defects = flatDefects(assembly, run.nearest());
		// A little less curvature is not worth the greater distance of a second attempt.
		if (better(assembly, defects, leastDefects, i == 0 ? 1 : tuning.worthwhile)) {
			leastDefects = defects;
			best.positions = run.nearest();
			best.smoothness = smoothnesses.maxCoeff();
		}
		if (best.ending != Ending::Stuck ||
			best.nearestDevelopable > 0) // more smoothness leads farther still
			break;
		if (problem.budget().spent() || hopeless(problem, run))
			break;
		if (i > 0)
			smoothnesses = problem.goal()
							   .unmetPatches(assembly, defects)
							   .select(tuning.smoothnessIncrease * smoothnesses, smoothnesses);
	}
	return best;
}

NewtonOutcome restoreFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress) {
	problem.setSmoothness(sameForAll(problem, smoothness));
	problem.jacobian().freeBorders(true);
	NewtonRun run(problem, start, maxIterations, progress);
	GaussNewton steps(problem, run, true, problem.goal().farthest);
	Ending ending = Ending::Unsolvable;
	if (!steps.unsolvable()) {
		const double epsilon = Continuation(problem, run, steps).leastEpsilon();
		ending = Restoration(problem, run, steps, epsilon).restore();
	}
	return {ending, run.iterations(), run.nearest(), smoothness};
}

} // namespace developable::detail
