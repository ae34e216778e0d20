// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_newton.cpp: checks, all parts by themselves, and what the report says of them.
#include "constrained_newton.h"

#include "newton_part.h"

namespace developable {

namespace {

using namespace detail;

/// Places beyond which a part's factors take so much memory that parts are solved one after the other.
constexpr int largePart = 100000;
constexpr double growth = 1.2; ///< time goes with this power of the number of places

void requireValid(const ConstrainedNewtonOptions& options) {
	requireOption(options.curvatureTolerance > 0, "The curvature tolerance must be greater than 0.");
	requireOption(options.angleTolerance > 0, "The angle tolerance must be greater than 0.");
	requireOption(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	requireOption(options.smoothness > 0 && options.smoothness <= 1,
				  "The smoothness must be greater than 0 and at most 1.");
	requireOption(options.fairness >= 0 && options.fairness <= 1, "The fairness must be between 0 and 1.");
	requireOption(std::isfinite(options.maxDisplacement), "The largest displacement must be a number.");
	requireOption(options.memoryLimit >= 0, "The limit of memory must not be negative.");
	requireOption(options.threads >= 0, "The number of threads must not be negative.");
}

/// Each part by itself. What comes of one depends neither on the others nor on the number of threads.
std::vector<PartOutcome> solveParts(const std::vector<AssemblyPart>& parts, const Positions& positions,
									const ConstrainedNewtonOptions& options, const Progress& progress) {
	std::vector<PartOutcome> outcomes(parts.size());
	std::vector<Task> small, large;
	double smallWork = 0, largeWork = 0;
	for (std::size_t i = 0; i < parts.size(); ++i) {
		const int places = parts[i].assembly.placeCount();
		const double work = std::pow(places, growth);
		const std::string prefix =
			parts.size() > 1 ? "part " + std::to_string(i + 1) + " of " + std::to_string(parts.size()) + ": "
							 : "";
		const bool isLarge = places > largePart;
		(isLarge ? largeWork : smallWork) += work;
		(isLarge ? large : small).push_back({work, [&, i, prefix](const Progress& progressOfPart) {
												 outcomes[i] =
													 solvePart(parts[i].assembly,
															   positions(Eigen::all, parts[i].wholePlace),
															   options, partOf(progressOfPart, 0, 1, prefix));
											 }});
	}
	const double share = largeWork / (largeWork + smallWork);
	runTasks(large, 1, partOf(progress, 0, share));
	runTasks(small, options.threads, partOf(progress, share, 1));
	return outcomes;
}

/// Of several parts the one that asks most of the user; of equals the first.
const PartOutcome& worstOf(const std::vector<PartOutcome>& outcomes) {
	constexpr Status order[] = {Status::Stopped,      Status::NeedsCut,  Status::Stalled,
								Status::LimitReached, Status::Converged, Status::NothingToDo};
	const auto rank = [&](const PartOutcome& outcome) {
		return std::pair(std::find(std::begin(order), std::end(order), outcome.status),
						 outcome.nearestDevelopable > 0);
	};
	return *std::min_element(outcomes.begin(), outcomes.end(),
							 [&](const PartOutcome& a, const PartOutcome& b) { return rank(a) < rank(b); });
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

/// \param overlaps  of the patch, where nothing else is in the way; 0 where something is
PatchVerdict verdictOf(const PartOutcome& outcome, int overlaps) {
	if (outcome.ending == Ending::Unsolvable)
		return {outcome.status, Reason::Unsolvable, outcome.nearestDevelopable};
	if (outcome.status == Status::NeedsCut && outcome.nearestDevelopable > 0)
		return {outcome.status, Reason::TooFar, outcome.nearestDevelopable};
	const bool ended = outcome.status == Status::NeedsCut || outcome.status == Status::Stalled;
	if (ended && overlaps > 0)
		return {outcome.status, Reason::BorderOverlaps, 0, overlaps};
	return {outcome.status};
}

/// Of each patch; within a part that has not got there some patches may have.
std::vector<PatchVerdict> patchVerdicts(const PatchAssembly& assembly, const Positions& positions,
										const CurvatureGoal& goal, const std::vector<AssemblyPart>& parts,
										const std::vector<PartOutcome>& outcomes) {
	const auto unmet = goal.unmetPatches(assembly, flatDefects(assembly, positions));
	const std::vector<int> overlaps = goal.borderOverlaps(assembly, positions);
	std::vector<PatchVerdict> verdicts(assembly.patchCount());
	for (std::size_t i = 0; i < parts.size(); ++i)
		for (const int patch : parts[i].wholePatch)
			if (unmet[patch])
				verdicts[patch] = verdictOf(outcomes[i], overlaps[patch]);
			else if (outcomes[i].status != Status::NothingToDo)
				verdicts[patch].status = Status::Converged;
	return verdicts;
}

/// Whether no patch that has not got there is stopped by anything else than its border.
bool onlyBordersOverlap(const std::vector<PatchVerdict>& verdicts) {
	return std::all_of(verdicts.begin(), verdicts.end(), [](const PatchVerdict& verdict) {
		return converged(verdict.status) || verdict.reason == Reason::BorderOverlaps;
	});
}

/// Where a border overlaps itself most.
void describeOverlap(const PatchAssembly& assembly, const Positions& positions,
					 ConstrainedNewtonReport& report) {
	report.reason = Reason::BorderOverlaps;
	borderAngles(assembly, positions).maxCoeff(&report.worstCopy);
	report.worstPatch = assembly.patchOfCopy[report.worstCopy];
	for (const PatchVerdict& verdict : report.patchVerdicts)
		report.borderOverlaps += verdict.borderOverlaps;
}

/// How many patches need a cut.
void describeNeedOfCut(const PartOutcome& worst, ConstrainedNewtonReport& report) {
	report.reason = worst.nearestDevelopable > 0 ? Reason::TooFar : Reason::NeedsCut;
	report.nearestDevelopable = worst.nearestDevelopable;
	report.patchesNeedingCut = static_cast<int>(
		std::count_if(report.patchVerdicts.begin(), report.patchVerdicts.end(),
					  [](const PatchVerdict& verdict) { return verdict.status == Status::NeedsCut; }));
}

/// Why it has not got there, and where it is worst.
void describeFailure(const PatchAssembly& assembly, const Positions& positions, const PartOutcome& worst,
					 ConstrainedNewtonReport& report) {
	if (report.status == Status::NeedsCut)
		describeNeedOfCut(worst, report);
	else if (worst.ending == Ending::Unsolvable)
		report.reason = Reason::Unsolvable;
	const bool overlaps = !converged(report.status) && onlyBordersOverlap(report.patchVerdicts);
	if (overlaps)
		describeOverlap(assembly, positions, report);
	if (overlaps || report.status == Status::NeedsCut) {
		const Eigen::Vector3d at = positions.col(assembly.placeOfCopy[report.worstCopy]);
		report.worstPosition = {at[0], at[1], at[2]};
	}
}

} // namespace

ConstrainedNewtonReport constrainedNewton(const PatchAssembly& assembly, Positions& positions,
										  const ConstrainedNewtonOptions& options, const Progress& progress) {
	requireValid(options);
	requireOpenPatches(assembly);
	requireFreePlaces(assembly);
	const CurvatureGoal goal{options.curvatureTolerance, options.angleTolerance};
	const std::vector<AssemblyPart> parts = partsOf(assembly);
	const std::vector<PartOutcome> outcomes = solveParts(parts, positions, options, neverBack(progress));
	const PartOutcome& worst = worstOf(outcomes);
	ConstrainedNewtonReport report;
	report.status = worst.status;
	for (const PartOutcome& outcome : outcomes) {
		report.iterations += outcome.iterations;
		report.work += outcome.work;
	}
	if (report.status == Status::Stopped)
		return report;
	// The places move last, when no memory can be missing any more.
	Positions solved = positions;
	for (std::size_t i = 0; i < parts.size(); ++i)
		solved(Eigen::all, parts[i].wholePlace) = outcomes[i].positions;
	report.patchVerdicts = patchVerdicts(assembly, solved, goal, parts, outcomes);
	describeShape(assembly, angleDefects(assembly, solved), report);
	describeFailure(assembly, solved, worst, report);
	positions.swap(solved);
	return report;
}

} // namespace developable
