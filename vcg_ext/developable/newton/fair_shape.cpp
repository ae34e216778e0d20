// SPDX-License-Identifier: GPL-3.0-or-later
// fair_shape.cpp: Newton's steps, each on the surface that the last has made.
#include "fair_shape.h"

#include "bending_metric.h"
#include "developable/geometry/geometry.h"
#include "displacement_metric.h"
#include "soundness.h"

namespace developable::detail {

namespace {

/// A step from x towards the least; nothing where rounding spoils the system.
Positions step(const PatchAssembly& shape, const PatchAssembly& original, double shapeSmoothness,
			   const NewtonTuning& tuning, double memoryLimit) {
	const Positions& positions = shape.originalPositions;
	BendingMetric metric(shape, tuning, memoryLimit);
	metric.setSmoothness(Eigen::VectorXd::Constant(shape.patchCount(), shapeSmoothness));
	if (!metric.factorize())
		return Positions::Zero(3, positions.cols());
	Positions pull =
		(nearestOnSurface(positions, original.originalPositions, original.trianglePlaces) - positions) *
		metric.placeMass().asDiagonal();
	for (int place = 0; place < shape.placeCount(); ++place)
		if (shape.placeFixed[place])
			pull.col(place).setZero();
	return metric.solve(pull - metric.bendingForce(positions, shapeSmoothness));
}

} // namespace

double shapeSmoothness(double fairness) {
	return std::pow(fairness / (2 * pi), 4);
}

PatchAssembly fairShape(const PatchAssembly& assembly, double shapeSmoothness, const CurvatureGoal& goal,
						const NewtonTuning& tuning, double memoryLimit) {
	NewtonTuning withoutRods = tuning; // seams go where their panels want them
	withoutRods.borderStiffness = 0;
	const Soundness soundness(assembly, tuning);
	PatchAssembly shape = assembly;
	for (int i = 0; i < tuning.fairSteps; ++i) {
		const Positions next =
			shape.originalPositions + step(shape, assembly, shapeSmoothness, withoutRods, memoryLimit);
		if (!(farthestMove(assembly, next) <= goal.farthest) || !soundness.holds(next))
			break;
		shape.originalPositions = next;
	}
	return shape;
}

} // namespace developable::detail
