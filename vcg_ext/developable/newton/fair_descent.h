// SPDX-License-Identifier: GPL-3.0-or-later
// fair_descent.h: from a developable shape to fairer ones.
#pragma once

#include "newton_run.h"
#include "unfairness.h"

#include <optional>

namespace developable::detail {

/// Lowers the unfairness among developable shapes, by sequential quadratic programming. In every round the
/// aim is where a step of Newton's method would lead, were it not for g = 0. Gauss-Newton steps lead towards
/// it as far as the curvature that they bring is not too dear, and a restoration back to g = 0. What does not
/// end at a fairer shape is tried with an aim half as far.
class FairDescent {
public:
	/// \param unfairness     of the original
	/// \param smoothness     α
	/// \param maxIterations  in every round
	FairDescent(const Unfairness& unfairness, double smoothness, const CurvatureGoal& goal, int maxIterations,
				double memoryLimit, const NewtonTuning& tuning, std::shared_ptr<WorkBudget> budget);

	/// \param positions  developable; the fairest shape that was found afterwards
	/// \return Reached, or Stopped
	Ending run(Positions& positions, const Progress& progress);

	/// Steps so far.
	int iterations() const { return iterations_; }

private:
	/// A fairer shape on the way along a share of a step, if it has found one.
	std::optional<Positions> along(const Unfairness::Step& step, double share, const Positions& from,
								   const Progress& progress);

	/// Steps towards what the problem is to be near, and back to g = 0.
	Ending approach(NewtonProblem& problem, NewtonRun& run) const;

	const Unfairness& unfairness_;
	const double smoothness_; // α
	const CurvatureGoal goal_;
	const int maxIterations_;
	const double memoryLimit_;
	const NewtonTuning tuning_;
	const std::shared_ptr<WorkBudget> budget_;
	double least_ = 0; // unfairness so far
	int iterations_ = 0;
	bool stopped_ = false;
};

} // namespace developable::detail
