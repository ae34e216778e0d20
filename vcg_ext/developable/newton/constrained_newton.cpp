// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_newton.cpp: checks, the run, and what the report says of it.
#include "constrained_newton.h"

#include "frozen_panels.h"

namespace developable {

namespace {

using namespace detail;

/// Of the work, as far as one can tell: what all patches together take before some are frozen.
constexpr double shareOfAllTogether = 0.7;

void requireValid(const ConstrainedNewtonOptions& options) {
	requireOption(options.curvatureTolerance > 0, "The curvature tolerance must be greater than 0.");
	requireOption(options.angleTolerance > 0, "The angle tolerance must be greater than 0.");
	requireOption(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	requireOption(options.smoothness > 0 && options.smoothness <= 1,
				  "The smoothness must be greater than 0 and at most 1.");
	requireOption(options.fairness >= 0 && options.fairness <= 1, "The fairness must be between 0 and 1.");
	requireOption(options.memoryLimit >= 0, "The limit of memory must not be negative.");
}

/// All patches together; then, where that is stuck, those that need no cut without the others.
NewtonOutcome solve(const PatchAssembly& assembly, const Positions& start, const NewtonStrategy& strategy,
					const Progress& progress) {
	const bool mayFreeze = assembly.patchCount() > 1 && !holdsPlaces(assembly);
	const double share = mayFreeze ? shareOfAllTogether : 1;
	NewtonOutcome outcome = strategy.solve(assembly, start, partOf(progress, 0, share));
	if (outcome.ending == Ending::Stopped)
		return outcome;
	if (!better(assembly, flatDefects(assembly, outcome.positions), flatDefects(assembly, start)))
		outcome.positions = start;
	if (outcome.ending != Ending::Stuck || !mayFreeze)
		return outcome;
	const Progress progressOfOthers = partOf(progress, share, 1, "without panels that need a cut: ");
	return FrozenPanels(assembly, start, strategy, progressOfOthers).finishOthers(outcome);
}

/// Without held places nothing else than the shape itself can stand in the way.
Status statusOf(Ending ending, const PatchAssembly& assembly) {
	switch (ending) {
	case Ending::Reached:
		return Status::Converged;
	case Ending::Settled:
	case Ending::Stuck:
		return holdsPlaces(assembly) ? Status::Stalled : Status::NeedsCut;
	case Ending::Unsolvable:
		return Status::Stalled;
	case Ending::OutOfSteps:
		return Status::LimitReached;
	case Ending::Stopped:
		return Status::Stopped;
	}
	return Status::Stalled;
}

/// What of the report is read off the shape.
void describeShape(const PatchAssembly& assembly, const Eigen::VectorXd& defects,
				   ConstrainedNewtonReport& report) {
	const Eigen::ArrayXd curvatures = patchCurvatures(assembly, defects);
	report.patchCurvature.assign(curvatures.begin(), curvatures.end());
	curvatures.maxCoeff(&report.worstPatch);
	double worst = -1;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.patchOfCopy[copy] == report.worstPatch && std::abs(defects[copy]) > worst) {
			worst = std::abs(defects[copy]);
			report.worstCopy = copy;
		}
}

/// How many patches need a cut, and where.
void describeNeedOfCut(const PatchAssembly& assembly, const Positions& positions, const CurvatureGoal& goal,
					   ConstrainedNewtonReport& report) {
	const auto unmet = goal.unmetPatches(assembly, flatDefects(assembly, positions));
	const Eigen::Vector3d at = positions.col(assembly.placeOfCopy[report.worstCopy]);
	report.reason = Reason::NeedsCut;
	report.patchesNeedingCut = static_cast<int>(unmet.count());
	report.worstPosition = {at[0], at[1], at[2]};
}

} // namespace

ConstrainedNewtonReport constrainedNewton(const PatchAssembly& assembly, Positions& positions,
										  const ConstrainedNewtonOptions& options, const Progress& progress) {
	requireValid(options);
	requireOpenPatches(assembly);
	requireFreePlaces(assembly);
	const CurvatureGoal goal{options.curvatureTolerance, options.angleTolerance};
	ConstrainedNewtonReport report;
	const Eigen::VectorXd defects = flatDefects(assembly, positions);
	if (goal.reached(assembly, defects)) {
		describeShape(assembly, defects, report);
		return report;
	}
	const NewtonStrategy strategy(options.smoothness, options.fairness, goal, options.maxIterations, options.memoryLimit,
								  options.tuning);
	const NewtonOutcome outcome = solve(assembly, positions, strategy, neverBack(progress));
	report.status = statusOf(outcome.ending, assembly);
	report.iterations = outcome.iterations;
	report.smoothness = outcome.smoothness;
	if (report.status == Status::Stopped)
		return report;
	positions = outcome.positions;
	describeShape(assembly, flatDefects(assembly, positions), report);
	if (report.status == Status::NeedsCut)
		describeNeedOfCut(assembly, positions, goal, report);
	if (outcome.ending == Ending::Unsolvable)
		report.reason = Reason::Unsolvable;
	return report;
}

} // namespace developable
