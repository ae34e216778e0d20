// SPDX-License-Identifier: GPL-3.0-or-later
// direct_newton.cpp: attempts with more and more smoothness.
#include "direct_newton.h"

namespace developable::detail {

NewtonOutcome solveDirectly(const PatchAssembly& assembly, const Positions& start, double smoothness,
							const CurvatureGoal& goal, int maxIterations, const Progress& progress) {
	Eigen::VectorXd smoothnesses = Eigen::VectorXd::Constant(assembly.patchCount(), smoothness);
	Eigen::VectorXd leastDefects = angleDefects(assembly, start);
	NewtonOutcome best;
	best.positions = start;
	for (int attempt = 0; attempt < 5; ++attempt) {
		NewtonAttempt run(assembly, smoothnesses, attempt > 0, goal, progress);
		const NewtonOutcome outcome = run.run(start, maxIterations - best.iterations);
		best.iterations += outcome.iterations;
		best.status = outcome.status;
		if (outcome.status == Status::Stopped)
			break;
		const Eigen::VectorXd defects = angleDefects(assembly, outcome.positions);
		// A little less curvature is not worth the greater distance of a second attempt.
		if (better(assembly, defects, leastDefects, attempt == 0 ? 1 : 0.1)) {
			leastDefects = defects;
			best.positions = outcome.positions;
			best.smoothness = smoothnesses.maxCoeff();
		}
		if (outcome.status != Status::Stalled || outcome.farOff) // more smoothness leads farther still
			break;
		if (attempt > 0)
			smoothnesses = goal.unmetPatches(assembly, defects).select(4 * smoothnesses, smoothnesses);
	}
	return best;
}

} // namespace developable::detail
