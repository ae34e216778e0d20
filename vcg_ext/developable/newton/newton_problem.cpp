// SPDX-License-Identifier: GPL-3.0-or-later
// newton_problem.cpp: shapes, and the metric that goes with them.
#include "newton_problem.h"

#include "displacement_metric.h"

namespace developable::detail {

double preferredMove(const PatchAssembly& part, const NewtonTuning& tuning, const CurvatureGoal& goal) {
	return std::min(tuning.preferredBound(boxDiagonal(part.originalPositions)), goal.farthest);
}

NewtonProblem::NewtonProblem(const PatchAssembly& assembly, const PatchAssembly& reference,
							 const CurvatureGoal& goal, const NewtonTuning& tuning, double memoryLimit,
							 double shapeSmoothness)
	: assembly_(assembly), reference_(reference), goal_(goal), tuning_(tuning), memoryLimit_(memoryLimit),
	  diagonal_(boxDiagonal(assembly.originalPositions)), metric_(reference, tuning, memoryLimit),
	  jacobian_(assembly, metric_.placeMass(), tuning.borderTurn * pi / 180), soundness_(assembly, tuning),
	  shapeSmoothness_(shapeSmoothness) {}

std::unique_ptr<NewtonProblem> NewtonProblem::another() const {
	auto result = std::make_unique<NewtonProblem>(assembly_, reference_, goal_, tuning_, memoryLimit_,
												  shapeSmoothness_);
	result->metric_.takeOver(metric_);
	return result;
}

void NewtonProblem::setSmoothness(double smoothness) {
	metric_.setSmoothness({Eigen::VectorXd::Constant(assembly_.patchCount(), smoothness), shapeSmoothness_});
	if (metric_.eliminationOrder().empty())
		findEliminationOrder();
	jacobian_.setPlaceMass(metric_.weight());
}

/// Of a matrix with the entries of all systems: with W's alone, steps along the normals take ten times as
/// long.
void NewtonProblem::findEliminationOrder() {
	const Positions& original = assembly_.originalPositions;
	NormalSystem system(memoryLimit_);
	system.findPattern(jacobian_.along(placeNormals(assembly_, original)), metric_.matrix());
	metric_.eliminateIn(eliminationOrder(system.lower()));
}

NormalSystem& NewtonProblem::normalSystem() {
	if (!normalSystem_)
		normalSystem_.emplace(memoryLimit_, metric_.eliminationOrder());
	return *normalSystem_;
}

void NewtonProblem::prepareNormalSystem() {
	const Positions& original = assembly_.originalPositions;
	jacobian_.linearize(original);
	normalSystem().prepare(jacobian_.along(placeNormals(assembly_, original)), metric_.matrix());
}

Shape NewtonProblem::shapeAt(const Positions& positions) const {
	const Eigen::VectorXd defects = flatDefects(assembly_, positions);
	return {positions, jacobian_.scaled(defects, positions), totalAbsoluteCurvature(defects),
			farthestMove(assembly_, positions), goal_.reached(assembly_, defects)};
}

bool NewtonProblem::hardlyFarther(const Shape& shape, const Shape& other) const {
	const auto mean = [&](const Shape& of) { return displacement(of).colwise().norm().mean(); };
	return mean(shape) <= tuning_.preferredPrice * mean(other);
}

bool NewtonProblem::beyondWay(const Shape& shape) const {
	const double mean = displacement(shape).colwise().norm().mean(), bound = goal_.farthest;
	return bound > 0 && (shape.farthest > tuning_.wayFarthest * bound || mean > tuning_.wayMean * bound);
}

void NewtonProblem::weigh(const Eigen::VectorXd& masses) {
	metric_.weigh(masses);
	jacobian_.setPlaceMass(metric_.weight());
}

bool NewtonProblem::stiffenFor(const Positions& positions) {
	const std::vector<int> spoilt = soundness_.spoiltTriangles(positions);
	metric_.stiffen(spoilt);
	return !spoilt.empty();
}

} // namespace developable::detail
