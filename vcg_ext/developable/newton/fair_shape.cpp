// SPDX-License-Identifier: GPL-3.0-or-later
// fair_shape.cpp: Newton's steps, each on the surface that the last has made.
#include "fair_shape.h"

#include "displacement_metric.h"
#include "soundness.h"

namespace developable::detail {

PatchAssembly fairShape(const Unfairness& unfairness, const CurvatureGoal& goal, const NewtonTuning& tuning) {
	const PatchAssembly& original = unfairness.original();
	const Soundness soundness(original, tuning);
	PatchAssembly shape = original;
	for (int i = 0; i < tuning.fairSteps; ++i) {
		const Positions next = shape.originalPositions + unfairness.step(shape.originalPositions).move;
		if (!(farthestMove(original, next) <= goal.farthest) || !soundness.holds(next))
			break;
		shape.originalPositions = next;
	}
	return shape;
}

} // namespace developable::detail
