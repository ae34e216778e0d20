// SPDX-License-Identifier: GPL-3.0-or-later
// multilevel_newton.cpp: coarse levels first, then refinement.
#include "multilevel_newton.h"

namespace developable::detail {

NewtonOutcome MultilevelNewton::solve(const PatchAssembly& assembly, const Positions& start,
									  const Progress& progress) const {
	if (assembly.placeCount() <= coarsest)
		return solveCoarsest(assembly, start, progress);
	const PartialAssembly coarse =
		Coarsening(assembly).coarsen(std::max(coarsest, assembly.placeCount() / ratio));
	if (coarse.assembly.placeCount() > leastReduction * assembly.placeCount())
		return solveCoarsest(assembly, start, progress);
	const Positions coarseStart = coarse.assembly.originalPositions +
								  (start - assembly.originalPositions)(Eigen::all, coarse.wholePlace);
	const auto begin = std::chrono::steady_clock::now();
	NewtonOutcome coarseOutcome = solve(coarse.assembly, coarseStart, part(progress, 0, coarseShare, ""));
	if (coarseOutcome.status == Status::Stopped)
		return coarseOutcome;
	const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
	const double sizes = double(assembly.placeCount()) / coarse.assembly.placeCount();
	return refine(assembly, coarse, coarseOutcome,
				  part(progress, coarseShare, 1, foresee(assembly, taken.count() * std::pow(sizes, growth))));
}

NewtonOutcome MultilevelNewton::solveCoarsest(const PatchAssembly& assembly, const Positions& start,
											  const Progress& progress) const {
	NewtonOutcome outcome = solveDirectly(assembly, start, smoothness_, goal_, maxIterations_, progress);
	const int stepsLeft = maxIterations_ - outcome.iterations;
	if (outcome.status != Status::Stalled || !holdsPlaces(assembly) || stepsLeft <= 0)
		return outcome;
	const double farthest = farthestShare * boxDiagonal(assembly.originalPositions);
	const NewtonOutcome more =
		NormalSteps(assembly, Soundness(assembly), smoothness_, goal_, memoryLimit_, progress)
			.run(outcome.positions, farthest, stepsLeft);
	outcome.iterations += more.iterations;
	outcome.positions = more.positions;
	if (more.status != Status::LimitReached)
		outcome.status = more.status;
	return outcome;
}

NewtonOutcome MultilevelNewton::refine(const PatchAssembly& assembly, const PartialAssembly& coarse,
									   const NewtonOutcome& coarseOutcome, const Progress& progress) const {
	const Positions displacement = prolonged(
		assembly, coarse, coarseOutcome.positions - coarse.assembly.originalPositions, memoryLimit_);
	Soundness soundness(assembly);
	const Positions begin = soundStart(assembly, soundness, displacement);
	// With a coarse solution at hand what is left to do is little; without one, more may do harm.
	const double diagonal = boxDiagonal(assembly.originalPositions);
	const double farthest = converged(coarseOutcome.status)
								? diagonal
								: std::max(farthestShare * diagonal, farthestDisplacement(assembly, begin));
	NewtonOutcome outcome =
		NormalSteps(assembly, std::move(soundness), smoothness_, goal_, memoryLimit_, progress)
			.run(begin, farthest, maxIterations_);
	outcome.smoothness = coarseOutcome.smoothness;
	if (outcome.status == Status::Stalled && converged(coarseOutcome.status)) {
		const Eigen::VectorXd smoothness = Eigen::VectorXd::Constant(assembly.patchCount(), smoothness_);
		const int steps = outcome.iterations;
		outcome = NewtonAttempt(assembly, smoothness, true, goal_, progress)
					  .landFrom(outcome.positions, maxIterations_ - steps);
		outcome.iterations += steps;
	}
	return outcome;
}

Positions MultilevelNewton::soundStart(const PatchAssembly& assembly, const Soundness& soundness,
									   const Positions& displacement) {
	double share = 1;
	while (share > 1e-3 && !soundness.holds(assembly.originalPositions + share * displacement))
		share /= 2;
	return assembly.originalPositions + share * displacement;
}

std::string MultilevelNewton::foresee(const PatchAssembly& assembly, double seconds) {
	const std::string size = std::to_string(assembly.placeCount()) + " vertices";
	if (seconds < 2)
		return size + ": ";
	if (seconds < 100)
		return size + ", about " + std::to_string(std::lround(seconds)) + " s: ";
	return size + ", about " + std::to_string(std::lround(seconds / 60)) + " min: ";
}

Progress MultilevelNewton::part(const Progress& progress, double begin, double end,
								const std::string& prefix) {
	if (!progress)
		return {};
	return [=](double fraction, const std::string& message) {
		return progress(begin + fraction * (end - begin), prefix + message);
	};
}

} // namespace developable::detail
