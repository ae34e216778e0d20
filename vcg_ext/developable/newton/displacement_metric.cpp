// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_metric.cpp: the metric with the same smoothness in every patch.
#include "displacement_metric.h"

#include "bending_matrix.h"
#include "fair_shape.h"
#include "soundness.h"

namespace developable {

namespace {

SparseMatrix metricOf(const PatchAssembly& assembly, double smoothness, double shapeSmoothness) {
	const detail::Smoothness dear = {Eigen::VectorXd::Constant(assembly.patchCount(), smoothness),
									 shapeSmoothness};
	return detail::BendingMatrix(assembly).lower(detail::placeMasses(assembly), dear,
												 NewtonTuning().borderStiffness);
}

} // namespace

SparseMatrix displacementMetric(const PatchAssembly& assembly, double smoothness) {
	return metricOf(assembly, smoothness, 0);
}

Nearness nearness(const PatchAssembly& assembly, double smoothness, double fairness) {
	if (fairness == 0)
		return {displacementMetric(assembly, smoothness), assembly.originalPositions};
	const double shapeSmoothness = detail::shapeSmoothness(fairness);
	const detail::Unfairness unfairness(assembly, shapeSmoothness, NewtonTuning(), 0);
	const PatchAssembly fair = detail::fairShape(unfairness, {}, NewtonTuning());
	return {metricOf(fair, smoothness, shapeSmoothness), fair.originalPositions};
}

double Nearness::squaredDistance(const Positions& shape) const {
	const Eigen::MatrixXd d = (shape - aim).transpose();
	return d.cwiseProduct(metric.selfadjointView<Eigen::Lower>() * d).sum();
}

double farthestMove(const PatchAssembly& assembly, const Positions& positions) {
	return (positions - assembly.originalPositions).colwise().norm().maxCoeff();
}

double farthestAllowed(const PatchAssembly& part, double maxDisplacement) {
	constexpr double byDefault = 0.15;
	return maxDisplacement < 0 ? byDefault * boxDiagonal(part.originalPositions) : maxDisplacement;
}

class TriangleOrder::Comparison : public detail::Soundness {
	using Soundness::Soundness;
};

TriangleOrder::TriangleOrder(const PatchAssembly& assembly)
	: comparison_(std::make_unique<Comparison>(assembly, NewtonTuning())) {}
TriangleOrder::TriangleOrder(TriangleOrder&&) noexcept = default;
TriangleOrder::~TriangleOrder() = default;

bool TriangleOrder::holds(const Positions& positions) const {
	return comparison_->holds(positions);
}

} // namespace developable
