// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_strain.cpp: checks, all parts by themselves, and what the report says of them.
#include "bounded_strain.h"

#include "bounded_part.h"
#include "developable/geometry/geometry.h"

#include <algorithm>
#include <cmath>

namespace developable {

namespace {

using namespace detail;

void requireValid(const BoundedStrainOptions& options) {
	requireValid(options.bounds);
	requireOption(options.bounds.any(),
				  "No strain is allowed: that is a task of the constrained Newton method.");
	requireOption(options.smoothness > 0 && options.smoothness <= 1,
				  "The smoothness must be greater than 0 and at most 1.");
	requireOption(options.fairness >= 0 && options.fairness <= 1, "The fairness must be between 0 and 1.");
	requireOption(std::isfinite(options.maxDisplacement), "The largest displacement must be a number.");
	requireOption(options.meanOnWay >= 0 && std::isfinite(options.meanOnWay),
				  "The mean displacement on the way must be a length, 0 or more.");
	requireOption(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	requireOption(options.leastRadius >= 0 && std::isfinite(options.leastRadius),
				  "The smallest radius must be a length, 0 or more.");
	requireOption(options.tolerance > 0, "The tolerance of strains must be greater than 0.");
	requireOption(options.threads >= 0, "The number of threads must not be negative.");
}

std::vector<BoundedOutcome> solveParts(const std::vector<AssemblyPart>& parts, const Positions& positions,
									   const BoundedStrainOptions& options, const Progress& progress) {
	std::vector<BoundedOutcome> outcomes(parts.size());
	std::vector<Task> tasks;
	for (std::size_t i = 0; i < parts.size(); ++i)
		tasks.push_back({std::pow(parts[i].assembly.placeCount(), 1.2), [&, i](const Progress& ofPart) {
							 outcomes[i] =
								 solveBounded(parts[i].assembly, positions(Eigen::all, parts[i].wholePlace),
											  options, ofPart);
						 }});
	runTasks(tasks, options.threads, progress);
	return outcomes;
}

/// Of several parts the one that asks most of the user; of equals the first.
Status worstOf(const std::vector<BoundedOutcome>& outcomes) {
	for (const Status status :
		 {Status::Stopped, Status::NeedsCut, Status::Stalled, Status::LimitReached, Status::Converged})
		for (const BoundedOutcome& outcome : outcomes)
			if (outcome.status == status)
				return status;
	return Status::NothingToDo;
}

/// Within a part that has not got there some patches may have.
void describePatches(const AssemblyPart& part, const BoundedOutcome& outcome, BoundedStrainReport& report) {
	std::vector<char> beyond(part.assembly.patchCount(), 0);
	for (int t = 0; t < part.assembly.triangleCount(); ++t)
		if (outcome.beyondBounds[t] > patternTolerance)
			beyond[part.assembly.patchOfTriangle[t]] = 1;
	for (int patch = 0; patch < part.assembly.patchCount(); ++patch) {
		PatchVerdict& verdict = report.patchVerdicts[part.wholePatch[patch]];
		if (!beyond[patch]) {
			verdict.status = outcome.status == Status::NothingToDo ? outcome.status : Status::Converged;
			verdict.reason = Reason::WithinBounds;
			continue;
		}
		verdict.status = outcome.status;
		verdict.nearestDevelopable = outcome.nearestDevelopable;
		verdict.reason = outcome.nearestDevelopable > 0 ? Reason::TooFar : Reason::BeyondBounds;
		report.patchesNeedingCut += outcome.status == Status::NeedsCut;
	}
}

/// Where the bounds are exceeded most, and what stands in the way.
void describeWorst(const AssemblyPart& part, const BoundedOutcome& outcome, BoundedStrainReport& report) {
	int worst = 0;
	const double beyond = outcome.beyondBounds.maxCoeff(&worst);
	if (beyond <= report.beyondBounds)
		return;
	report.beyondBounds = beyond;
	const Eigen::Vector3d at = barycentre(outcome.positions, part.assembly.trianglePlaces.col(worst));
	report.worstPosition = {at[0], at[1], at[2]};
	if (outcome.status == Status::NeedsCut) {
		report.nearestDevelopable = outcome.nearestDevelopable;
		report.reason = outcome.nearestDevelopable > 0 ? Reason::TooFar : Reason::BeyondBounds;
	}
}

} // namespace

BoundedStrainReport boundedStrain(const PatchAssembly& assembly, Positions& positions,
								  const BoundedStrainOptions& options, const Progress& progress) {
	requireValid(options);
	requireFreePlaces(assembly);
	requireOpenPatches(assembly);
	const std::vector<AssemblyPart> parts = partsOf(assembly);
	std::vector<BoundedOutcome> outcomes = solveParts(parts, positions, options, neverBack(progress));
	BoundedStrainReport report;
	report.status = worstOf(outcomes);
	for (const BoundedOutcome& outcome : outcomes)
		report.iterations += outcome.iterations;
	if (report.status == Status::Stopped)
		return report;
	report.patchVerdicts.resize(assembly.patchCount());
	if (converged(report.status))
		report.reason = Reason::WithinBounds;
	for (std::size_t i = 0; i < parts.size(); ++i) {
		positions(Eigen::all, parts[i].wholePlace) = outcomes[i].positions;
		describePatches(parts[i], outcomes[i], report);
		describeWorst(parts[i], outcomes[i], report);
	}
	if (converged(report.status))
		report.worstPosition = {};
	if (outcomes.size() == 1) // whose numbering is that of the whole
		report.patterns = std::move(outcomes.front().patterns);
	return report;
}

} // namespace developable
