// SPDX-License-Identifier: GPL-3.0-or-later
// refinement.cpp: beside the coarse solution, or after it.
#include "refinement.h"

namespace developable::detail {

Refinement::Refinement(const PatchAssembly& fine, const PartialAssembly& coarse, const NewtonTuning& tuning,
					   double memoryLimit, MakeProblem makeProblem)
	: fine_(fine), coarse_(coarse), tuning_(tuning), memoryLimit_(memoryLimit),
	  makeProblem_(std::move(makeProblem)) {}

void Refinement::prepareBeside(const Task& coarseSolution, const Progress& progress) {
	if (threadsAtHand() == 1)
		return coarseSolution.run(progress);
	// How far all is, the coarse solution alone says.
	const Task prolongation = {0, [this](const Progress&) { makeProlongation(); }};
	const Task normalSystem = {0, [this](const Progress&) { problem().prepareNormalSystem(); }};
	runTasks({coarseSolution, prolongation, normalSystem}, 0, progress);
}

Positions Refinement::prolonged(const Positions& coarseDisplacement) {
	if (!prolongation_)
		makeProlongation();
	const Positions result = prolongation_->of(coarseDisplacement);
	prolongation_.reset();
	return result;
}

NewtonProblem& Refinement::problem() {
	if (!problem_)
		problem_ = makeProblem_();
	return *problem_;
}

} // namespace developable::detail
