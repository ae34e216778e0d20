// SPDX-License-Identifier: GPL-3.0-or-later
// unfairness.cpp: its value, and steps that lower it.
#include "unfairness.h"

#include "bending_metric.h"
#include "developable/geometry/geometry.h"

namespace developable::detail {

namespace {

/// ‖distance‖₄², of squared distances.
double fourthNorm(const Eigen::VectorXd& squares, const Eigen::VectorXd& masses) {
	return std::sqrt(masses.dot(squares.cwiseAbs2()));
}

Eigen::VectorXd extraMasses(const Positions& distances, const Eigen::VectorXd& masses) {
	const Eigen::VectorXd squares = distances.colwise().squaredNorm();
	const double norm = fourthNorm(squares, masses);
	if (!(norm > 0))
		return Eigen::VectorXd::Zero(masses.size());
	return masses.cwiseProduct(squares) / norm;
}

PatchAssembly movedTo(const PatchAssembly& assembly, const Positions& positions) {
	PatchAssembly moved = assembly;
	moved.originalPositions = positions;
	return moved;
}

} // namespace

double shapeSmoothness(double fairness) {
	return std::pow(fairness / (2 * pi), 4);
}

Unfairness::Unfairness(const PatchAssembly& original, double shapeSmoothness, const NewtonTuning& tuning,
					   double memoryLimit)
	: original_(original), shapeSmoothness_(shapeSmoothness), tuning_(tuning), memoryLimit_(memoryLimit) {
	tuning_.borderStiffness = 0; // seams go where their panels want them
}

double Unfairness::at(const Positions& positions) const {
	const PatchAssembly shape = movedTo(original_, positions);
	BendingMetric metric(shape, tuning_, memoryLimit_);
	const Eigen::VectorXd squares = toOriginal(positions).colwise().squaredNorm();
	const Smoothness smoothness = {Eigen::VectorXd::Zero(shape.patchCount()), shapeSmoothness_};
	return squares.dot(metric.placeMass()) + fourthNorm(squares, metric.placeMass()) +
		   positions.cwiseProduct(metric.bendingForce(positions, smoothness)).sum();
}

Unfairness::Step Unfairness::step(const Positions& positions) const {
	const PatchAssembly shape = movedTo(original_, positions);
	BendingMetric metric(shape, tuning_, memoryLimit_);
	const Smoothness smoothness = {Eigen::VectorXd::Zero(shape.patchCount()), shapeSmoothness_};
	metric.setSmoothness(smoothness);
	Positions pull = toOriginal(positions);
	Step result = {Positions::Zero(3, positions.cols()), extraMasses(pull, metric.placeMass())};
	metric.weigh(result.extraMasses);
	if (!metric.factorize())
		return result;
	pull *= metric.weight().asDiagonal();
	for (int place = 0; place < shape.placeCount(); ++place)
		if (shape.placeFixed[place])
			pull.col(place).setZero();
	result.move = metric.solve(pull - metric.bendingForce(positions, smoothness));
	return result;
}

Positions Unfairness::toOriginal(const Positions& positions) const {
	return nearestOnSurface(positions, original_.originalPositions, original_.trianglePlaces) - positions;
}

} // namespace developable::detail
