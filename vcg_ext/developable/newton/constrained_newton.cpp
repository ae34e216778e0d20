// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_newton.cpp: checks, the run, and what the report says of it.
#include "constrained_newton.h"

namespace developable {

void detail::requireValid(const ConstrainedNewtonOptions& options) {
	const auto require = [](bool valid, const std::string& what) {
		if (!valid)
			throw InvalidParameter(what);
	};
	require(options.curvatureTolerance > 0, "The curvature tolerance must be greater than 0.");
	require(options.angleTolerance > 0, "The angle tolerance must be greater than 0.");
	require(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	require(options.smoothness > 0 && options.smoothness <= 1,
			"The smoothness must be greater than 0 and at most 1.");
	require(options.memoryLimit >= 0, "The limit of memory must not be negative.");
}

void detail::describeShape(const PatchAssembly& assembly, const Eigen::VectorXd& defects,
						   ConstrainedNewtonReport& report) {
	const Eigen::ArrayXd curvatures = detail::patchCurvatures(assembly, defects);
	report.patchCurvature.assign(curvatures.begin(), curvatures.end());
	curvatures.maxCoeff(&report.worstPatch);
	double worst = -1;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.patchOfCopy[copy] == report.worstPatch && std::abs(defects[copy]) > worst) {
			worst = std::abs(defects[copy]);
			report.worstCopy = copy;
		}
}

std::string detail::describeNeedOfCut(const PatchAssembly& assembly, const Positions& positions,
									  const detail::CurvatureGoal& goal,
									  const ConstrainedNewtonReport& report) {
	const auto unmet = goal.unmetPatches(assembly, angleDefects(assembly, positions));
	const Eigen::Vector3d at = positions.col(assembly.placeOfCopy[report.worstCopy]);
	char text[160];
	std::snprintf(text, sizeof text, " in %d of %d patches, first of all at (%.4g, %.4g, %.4g)",
				  static_cast<int>(unmet.count()), assembly.patchCount(), at[0], at[1], at[2]);
	return describe(Status::NeedsCut) + text;
}

ConstrainedNewtonReport constrainedNewton(const PatchAssembly& assembly, Positions& positions,
										  const ConstrainedNewtonOptions& options, const Progress& progress) {
	detail::requireValid(options);
	requireOpenPatches(assembly);
	requireFreePlaces(assembly);
	const detail::CurvatureGoal goal{options.curvatureTolerance, options.angleTolerance};
	ConstrainedNewtonReport report;
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	if (!goal.unmetPatches(assembly, defects).any()) {
		detail::describeShape(assembly, defects, report);
		return report;
	}
	const detail::MultilevelNewton solver(options.smoothness, goal, options.maxIterations,
										  options.memoryLimit);
	detail::NewtonOutcome outcome = solver.solve(assembly, positions, progress);
	if (outcome.status != Status::Stopped &&
		!detail::better(assembly, angleDefects(assembly, outcome.positions), defects))
		outcome.positions = positions;
	if (outcome.status == Status::Stalled && !detail::holdsPlaces(assembly)) {
		outcome.status = Status::NeedsCut;
		outcome = detail::RestingPatches(assembly, positions, solver, goal, progress).finishOthers(outcome);
	}
	report.status = outcome.status;
	report.iterations = outcome.iterations;
	report.smoothness = outcome.smoothness;
	if (outcome.status == Status::Stopped)
		return report;
	positions = outcome.positions;
	detail::describeShape(assembly, angleDefects(assembly, positions), report);
	if (report.status == Status::NeedsCut)
		report.reason = detail::describeNeedOfCut(assembly, positions, goal, report);
	return report;
}

} // namespace developable
