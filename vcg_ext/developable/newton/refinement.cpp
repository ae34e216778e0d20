// SPDX-License-Identifier: GPL-3.0-or-later
// refinement.cpp: beside the coarse solution, or after it.
#include "refinement.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

namespace {

constexpr int muchMemory = 200000; ///< places beyond which two preparations at once would take too much

} // namespace

Refinement::Refinement(const PatchAssembly& fine, const PartialAssembly& coarse, const NewtonTuning& tuning,
					   double memoryLimit, MakeProblem makeProblem)
	: fine_(fine), coarse_(coarse), tuning_(tuning), memoryLimit_(memoryLimit),
	  makeProblem_(std::move(makeProblem)) {}

void Refinement::prepareBeside(const std::function<void()>& solveCoarse) {
	const bool oneAfterTheOther = fine_.placeCount() > muchMemory;
	TaskAhead normalSystem([this](const Progress&) { problem().prepareNormalSystem(); });
	TaskAhead prolongation([&](const Progress&) {
		makeProlongation();
		if (oneAfterTheOther)
			problem().prepareNormalSystem();
	});
	if (threadsAtHand() > 1) {
		prolongation.begin();
		if (!oneAfterTheOther)
			normalSystem.begin();
	}
	solveCoarse();
	for (TaskAhead* const task : {&prolongation, &normalSystem})
		if (task->begun())
			task->finish({});
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
