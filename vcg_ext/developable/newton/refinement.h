// SPDX-License-Identifier: GPL-3.0-or-later
// refinement.h: what a fine level needs that does not depend on the coarse solution.
#pragma once

#include "newton_problem.h"
#include "prolongation.h"

#include <functional>
#include <optional>

namespace developable::detail {

/// The factorised prolongation and the fine problem with its metric and the patterns of its systems. They are
/// made while the coarse level is solved where another thread is at hand, else when they are asked for.
class Refinement {
public:
	using MakeProblem = std::function<std::unique_ptr<NewtonProblem>()>;

	/// \param makeProblem  that of the fine level
	Refinement(const PatchAssembly& fine, const PartialAssembly& coarse, const NewtonTuning& tuning,
			   double memoryLimit, MakeProblem makeProblem);

	/// Runs what solves the coarse level, and makes the rest beside it.
	void prepareBeside(const std::function<void()>& solveCoarse);

	/// See Prolongation; to be called before `prolonged`.
	Positions smoothing(const Positions& positions);

	/// See Prolongation; to be called once, as its memory is given back.
	Positions prolonged(const Positions& coarseDisplacement);

	NewtonProblem& problem();

private:
	const Prolongation& prolongation();

	const PatchAssembly& fine_;
	const PartialAssembly& coarse_;
	const NewtonTuning tuning_;
	const double memoryLimit_;
	const MakeProblem makeProblem_;
	std::optional<Prolongation> prolongation_;
	std::unique_ptr<NewtonProblem> problem_;
};

} // namespace developable::detail
