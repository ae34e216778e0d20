// SPDX-License-Identifier: GPL-3.0-or-later
// multilevel_newton.h: the constrained Newton method from coarse to fine.
#pragma once

#include "direct_newton.h"
#include "normal_steps.h"
#include "prolongation.h"

#include <chrono>

namespace developable::detail {

/// Large patches are first solved with a quarter of their vertices, in the same way. That solution's
/// displacement, carried over smoothly, brings the fine patches to where little curvature is left, and all of
/// it of short waves: steps along the normals take it away. What they can't take, shortest steps in all three
/// directions may.
class MultilevelNewton {
public:
	/// \param memoryLimit  see SparseSolver
	MultilevelNewton(double smoothness, const CurvatureGoal& goal, int maxIterations, double memoryLimit)
		: smoothness_(smoothness), goal_(goal), maxIterations_(maxIterations), memoryLimit_(memoryLimit) {}

	NewtonOutcome solve(const PatchAssembly& assembly, const Positions& start,
						const Progress& progress) const;

private:
	static constexpr int coarsest = 1500;         ///< so few places are solved directly
	static constexpr int ratio = 4;               ///< between the numbers of places of two levels
	static constexpr double leastReduction = 0.7; ///< else a level is not worth its while
	static constexpr double coarseShare = 0.2;    ///< of a level's work that the coarser levels are
	static constexpr double growth = 1.2;         ///< time goes with this power of the number of places

	/// Where held places leave no way to g = 0, steps along the normals go on to the least squares of it.
	NewtonOutcome solveCoarsest(const PatchAssembly& assembly, const Positions& start,
								const Progress& progress) const;

	NewtonOutcome refine(const PatchAssembly& assembly, const PartialAssembly& coarse,
						 const NewtonOutcome& coarseOutcome, const Progress& progress) const;

	/// The whole displacement, or as much of it as leaves the triangles in order.
	static Positions soundStart(const PatchAssembly& assembly, const Soundness& soundness,
								const Positions& displacement);

	/// What is about to be done, and how long it may take.
	static std::string foresee(const PatchAssembly& assembly, double seconds);

	/// What a part of the work says, as that part of the whole.
	static Progress part(const Progress& progress, double begin, double end, const std::string& prefix);

	const double smoothness_;
	const CurvatureGoal goal_;
	const int maxIterations_;
	const double memoryLimit_;
};

} // namespace developable::detail
