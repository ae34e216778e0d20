// SPDX-License-Identifier: GPL-3.0-or-later
// least_curvature.cpp: weighted steps along the normals.
#include "least_curvature.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// The part, with the places of its developable patches held.
PatchAssembly heldWhereDevelopable(const PatchAssembly& part, const Positions& positions,
								   const CurvatureGoal& goal) {
	PatchAssembly held = part;
	const auto unmet = goal.unmetPatches(part, flatDefects(part, positions));
	for (int copy = 0; copy < part.copyCount(); ++copy)
		if (!unmet[part.patchOfCopy[copy]])
			held.placeFixed[part.placeOfCopy[copy]] = 1;
	return held;
}

/// Less where much was done before.
double workFor(const PatchAssembly& part, const NewtonOutcome& outcome, const NewtonTuning& tuning) {
	constexpr double inAll = 3, least = 0.25; // times that
	const double usual = tuning.curvatureWorkPerPlace * part.placeCount();
	return std::clamp(inAll * usual - outcome.work, least * usual, usual);
}

} // namespace

LeastCurvature::LeastCurvature(NewtonProblem& problem, NewtonRun& run)
	: problem_(problem), run_(run), step_(problem),
	  delta_(run.shape().curvature / std::max(1, problem.assembly().interiorCopyCount())) {}

Ending LeastCurvature::run() {
	const NewtonTuning& tuning = problem_.tuning();
	const double leastDelta = tuning.curvatureSharpest * delta_;
	for (int idle = 0; !run_.shape().reached;
		 delta_ = std::max(leastDelta, tuning.curvatureSharpening * delta_)) {
		if (!run_.mayGoOn())
			return Ending::Stopped;
		if (!run_.takeStep())
			return Ending::OutOfSteps;
		const double before = run_.shape().curvature;
		const double length = step();
		const double share = run_.shape().curvature / before;
		idle = share > tuning.curvatureIdle ? idle + 1 : 0;
		if (idle == tuning.normalPatience)
			return Ending::Stuck;
		epsilon_ *= epsilonFactor(share, length);
	}
	return Ending::Reached;
}

/// Smaller after a full step, the more so the more it removed; larger by as much as the step had to be cut
/// short.
double LeastCurvature::epsilonFactor(double shareLeft, double length) const {
	const NewtonTuning& tuning = problem_.tuning();
	if (length == 0)
		return tuning.normalRetry;
	if (length == 1)
		return shareLeft < tuning.curvatureGood ? tuning.normalDecrease : tuning.normalSlowDecrease;
	return 1 / length;
}

double LeastCurvature::step() {
	const Eigen::VectorXd weights = (defects(run_.shape()).square() + delta_ * delta_).pow(-0.25) /
									problem_.jacobian().rowScale().array();
	if (!step_.factorize(run_.shape(), weights, epsilon_))
		return 0;
	return run_.descend(
		step_.whole(), [this](const Shape& shape) { return merit(shape); }, step_.slope(),
		problem_.tuning().normalHalvings, problem_.goal().farthest);
}

Eigen::ArrayXd LeastCurvature::defects(const Shape& shape) const {
	return shape.scaledDefects.array() / problem_.jacobian().rowScale().array();
}

void lowerCurvature(const PatchAssembly& part, const Positions& start,
					const ConstrainedNewtonOptions& options, const CurvatureGoal& goal,
					NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = options.tuning;
	const PatchAssembly held = heldWhereDevelopable(part, outcome.positions, goal);
	NewtonProblem problem(held, goal, tuning, options.memoryLimit);
	problem.setBudget(std::make_shared<WorkBudget>(workFor(part, outcome, tuning)));
	problem.setSmoothness(options.smoothness);
	problem.jacobian().freeBorders(true);
	NewtonRun run(problem, outcome.positions, tuning.curvatureSteps, progress);
	const Ending ending = LeastCurvature(problem, run).run();
	outcome.iterations += run.iterations();
	outcome.work += problem.budget().used();
	if (ending == Ending::Stopped)
		outcome.ending = ending;
	const Eigen::VectorXd defects = flatDefects(part, run.nearest());
	if (better(part, defects, flatDefects(part, start)) &&
		lessCurved(part, defects, flatDefects(part, outcome.positions)))
		outcome.positions = run.nearest();
}

} // namespace developable::detail
