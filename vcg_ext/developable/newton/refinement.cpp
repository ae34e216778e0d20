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
		prolongation();
		problem().prepareNormalSystem();
	});
	if (threadsAtHand() > 1)
		preparation.begin();
	solveCoarse();
	if (preparation.begun())
		preparation.finish({});
}

Positions Refinement::smoothing(const Positions& positions) {
	return prolongation().smoothing(positions);
}

Positions Refinement::prolonged(const Positions& coarseDisplacement) {
	Positions result = prolongation().of(coarseDisplacement);
	prolongation_.reset();
	return result;
}

const Prolongation& Refinement::prolongation() {
	if (!prolongation_) {
		BendingMetric& metric = problem().metric();
		prolongation_.emplace(fine_, coarse_, metric.bending(), tuning_, metric.eliminationOrder(),
							  memoryLimit_);
	}
	return *prolongation_;
}

NewtonProblem& Refinement::problem() {
	if (!problem_)
		problem_ = makeProblem_();
	return *problem_;
}

} // namespace developable::detail
