// SPDX-License-Identifier: GPL-3.0-or-later
// refinement.cpp: beside the coarse solution, or after it.
#include "refinement.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

Refinement::Refinement(const PatchAssembly& fine, const PartialAssembly& coarse, const NewtonTuning& tuning,
					   double memoryLimit, MakeProblem makeProblem)
	: fine_(fine), coarse_(coarse), tuning_(tuning), memoryLimit_(memoryLimit),
	  makeProblem_(std::move(makeProblem)) {}

void Refinement::prepareBeside(const std::function<void()>& solveCoarse) {
	TaskAhead preparation([&](const Progress&) {
		makeProlongation();
		problem().prepareNormalSystem();
	});
	if (threadsAtHand() > 1)
		preparation.begin();
	solveCoarse();
	if (preparation.begun())
		preparation.finish({});
}

Positions Refinement::prolonged(const Positions& coarseDisplacement) {
	if (!prolongation_)
		makeProlongation();
	Positions result = prolongation_->of(coarseDisplacement);
	prolongation_.reset();
	return result;
}

NewtonProblem& Refinement::problem() {
	if (!problem_)
		problem_ = makeProblem_();
	return *problem_;
}

} // namespace developable::detail
