// SPDX-License-Identifier: GPL-3.0-or-later
// optimization_runs.cpp: the methods that move vertices.
#include "runs.h"

#include "developable/local/local_method.h"
#include "developable/newton/constrained_newton.h"
#include "developable/penalty/penalty_method.h"

#include <cmath>
#include <limits>

namespace developable::fuzz {

namespace {

/// Checks the shares it is told, and now and then asks for a stop.
class Listener {
public:
	Listener(Random& random, Findings& findings)
		: findings_(findings), callsUntilStop_(random.chance(0.1) ? random.below(4) : -1) {}

	Progress progress() {
		return [this](double fractionDone, const std::string& message) {
			findings_.expect(fractionDone >= 0 && fractionDone <= 1 && !message.empty(),
							 "progress of " + std::to_string(fractionDone));
			return callsUntilStop_ < 0 || callsUntilStop_-- > 0;
		};
	}

private:
	Findings& findings_;
	int callsUntilStop_;
};

/// Runs a method on a copy of the original positions. When it throws they have to be as they were.
template <class Run>
Positions moved(const PatchAssembly& assembly, Findings& findings, const Run& run,
				AtBorders atBorders = AtBorders::Nothing) {
	Positions positions = assembly.originalPositions;
	Status status = Status::NothingToDo;
	try {
		status = run(positions).status;
	} catch (...) {
		findings.expect(positions == assembly.originalPositions, "positions changed by a run that threw");
		throw;
	}
	if (status == Status::Stopped || status == Status::NothingToDo)
		findings.expect(positions == assembly.originalPositions,
						"positions changed though " + describe(status));
	checkResult(assembly, assembly.originalPositions, positions, findings, atBorders);
	return positions;
}

/// That "converged" is true of angle defects worked out anew.
void checkConverged(const PatchAssembly& assembly, const Positions& positions, Status status,
					double angleTolerance, Findings& findings) {
	if (!converged(status))
		return;
	const OwnDefects defects = ownDefects(assembly, positions);
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		findings.expect(std::abs(defects.values[copy]) <= angleTolerance * (1 + 1e-9) + defects.errors[copy],
						"converged with an angle defect of " + std::to_string(defects.values[copy]));
}

ConstrainedNewtonOptions newtonOptions(Random& random, double diagonal) {
	ConstrainedNewtonOptions options;
	options.maxIterations = random.below(12);
	options.curvatureTolerance = random.oneOf({1e-4, 1e-2, 1e-10});
	options.angleTolerance = random.oneOf({1e-4, 1e-2, 1e-10});
	options.smoothness = random.oneOf({3e-6, 1e-12, 1.0});
	options.memoryLimit = random.oneOf({0.0, 0.0, 1.0});
	options.tuning.coarsest = random.oneOf({1500, 1500, 12}); // several levels in a small mesh
	options.fairness = random.oneOf({0.0, 0.0, 0.1, 1.0});
	options.maxDisplacement = random.oneOf({-1.0, -1.0, 0.0, 1e-3 * diagonal, 0.1 * diagonal});
	options.threads = random.below(3);
	if (random.chance(0.03))
		options.fairness = random.oneOf({-1.0, 2.0, std::nan("")});
	if (random.chance(0.03))
		options.maxDisplacement = random.oneOf({std::nan(""), std::numeric_limits<double>::infinity()});
	if (random.chance(0.03))
		options.smoothness = random.oneOf({0.0, -1.0, 2.0, std::nan("")});
	if (random.chance(0.03))
		options.angleTolerance = random.oneOf({0.0, -1.0, std::nan("")});
	return options;
}

void checkNewtonReport(const PatchAssembly& assembly, const Positions& positions,
					   const ConstrainedNewtonOptions& options, const ConstrainedNewtonReport& report,
					   Findings& findings) {
	const OwnDefects defects = ownDefects(assembly, positions);
	const std::vector<double> own = ownPatchCurvatures(assembly, defects);
	findings.expect(report.patchCurvature.size() == own.size(), "a wrong number of patches in the report");
	for (std::size_t patch = 0; patch < std::min(own.size(), report.patchCurvature.size()); ++patch) {
		const double slack = defects.errors.sum() + 1e-9 * own[patch];
		findings.expect(std::abs(report.patchCurvature[patch] - own[patch]) <= slack,
						"a wrong patch curvature");
		findings.expect(!converged(report.status) || own[patch] <= options.curvatureTolerance + slack,
						"converged with a patch curvature of " + std::to_string(own[patch]));
	}
	findings.expect(report.worstPatch >= 0 && report.worstPatch < assembly.patchCount() &&
						report.worstCopy >= 0 && report.worstCopy < assembly.copyCount(),
					"a worst patch or copy that is none");
	checkConverged(assembly, positions, report.status, options.angleTolerance, findings);
}

} // namespace

void runConstrainedNewton(Random& random, const PatchAssembly& assembly, Findings& findings) {
	const double diagonal = boxDiagonal(assembly.originalPositions);
	const ConstrainedNewtonOptions options = newtonOptions(random, diagonal);
	Listener listener(random, findings);
	ConstrainedNewtonReport report;
	const Positions positions = moved(
		assembly, findings,
		[&](Positions& current) {
			return report = constrainedNewton(assembly, current, options, listener.progress());
		},
		AtBorders::AnglesBeyondATurn);
	checkTrianglesInOrder(assembly, positions, findings);
	const double farthest = options.maxDisplacement < 0 ? 0.15 * diagonal : options.maxDisplacement;
	findings.expect((positions - assembly.originalPositions).colwise().norm().maxCoeff() <=
						farthest + 1e-15 * assembly.originalPositions.cwiseAbs().maxCoeff(),
					"a vertex has moved farther than it may");
	if (report.status != Status::Stopped)
		checkNewtonReport(assembly, positions, options, report, findings);
}

void runPenaltyMethod(Random& random, const PatchAssembly& assembly, Findings& findings) {
	PenaltyMethodOptions options;
	options.angleTolerance = random.oneOf({1e-4, 1e-2, 0.0});
	options.relativeChange = random.oneOf({1e-4, 0.0, 0.5});
	options.maxIterations = random.below(12);
	Listener listener(random, findings);
	Status status = Status::NothingToDo;
	const Positions positions = moved(assembly, findings, [&](Positions& current) {
		const OptimizationReport report = penaltyMethod(assembly, current, options, listener.progress());
		status = report.status;
		return report;
	});
	checkConverged(assembly, positions, status, options.angleTolerance, findings);
}

void runLocalMethod(Random& random, const PatchAssembly& assembly, Findings& findings) {
	LocalMethodOptions options;
	options.angleTolerance = random.oneOf({1e-4, 1e-2, 0.0});
	options.maxDisplacement =
		random.oneOf({LocalMethodOptions::meanEdge, 0.0, 0.1 * boxDiagonal(assembly.originalPositions)});
	options.maxOperations = random.below(3000);
	options.descent = random.chance(0.5);
	options.smoothing = random.oneOf({0.0, 0.0, 0.1, 10.0});
	options.assemblingVertices = random.oneOf({AssemblingVertices::Fixed, AssemblingVertices::MoveTogether});
	options.avoidSelfIntersections = random.chance(0.3);
	options.roundedToFloat = random.chance(0.5);
	Listener listener(random, findings);
	Status status = Status::NothingToDo;
	const Positions positions = moved(assembly, findings, [&](Positions& current) {
		const LocalMethodReport report = localMethod(assembly, current, options, listener.progress());
		status = report.status;
		return report;
	});
	checkConverged(assembly, positions, status, options.angleTolerance, findings);
	const double farthest = options.maxDisplacement == LocalMethodOptions::meanEdge ? meanEdgeLength(assembly)
																					: options.maxDisplacement;
	const double rounding = 1e-15 * assembly.originalPositions.cwiseAbs().maxCoeff();
	for (int place = 0; place < assembly.placeCount(); ++place) {
		const double distance = (positions.col(place) - assembly.originalPositions.col(place)).norm();
		findings.expect(distance <= farthest * (1 + 1e-12) + rounding, "a vertex has moved too far");
		findings.expect(distance == 0 || !assembly.placeAssembling[place] ||
							options.assemblingVertices == AssemblingVertices::MoveTogether,
						"a vertex where patches meet has moved");
	}
}

} // namespace developable::fuzz
