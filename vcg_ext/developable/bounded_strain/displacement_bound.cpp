// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_bound.cpp: a sum over the places, each by its distance from where it was.
#include "displacement_bound.h"

#include "developable/geometry/geometry.h"

namespace developable::detail {

namespace {

constexpr double margin = 1e-3; ///< share of the bound by which places keep away from it

Eigen::VectorXd sharesOfArea(const PatchAssembly& assembly) {
	Eigen::VectorXd shares = Eigen::VectorXd::Zero(assembly.placeCount());
	for (const auto& places : assembly.trianglePlaces.colwise()) {
		const double area = triangleFrame(assembly.originalPositions, places).normal.norm();
		for (const int place : places)
			shares[place] += area;
	}
	return shares / shares.sum();
}

} // namespace

DisplacementBound::DisplacementBound(const PatchAssembly& assembly, double farthest)
	: assembly_(assembly), farthest_(farthest), radius_((1 - margin) * farthest),
	  masses_(sharesOfArea(assembly)) {}

double DisplacementBound::value(const RoundedPenalty& edge, const Positions& shape) const {
	double sum = 0;
	for (int place = 0; place < assembly_.placeCount(); ++place)
		sum += masses_[place] * edge.value(excess(displacement(shape, place)));
	return sum;
}

Eigen::Vector3d DisplacementBound::gradient(const RoundedPenalty& edge, const Positions& shape,
											int place) const {
	const Eigen::Vector3d d = displacement(shape, place);
	return masses_[place] * edge.first(excess(d)) / radius_ * d.stableNormalized();
}

Eigen::Matrix3d DisplacementBound::hessian(const RoundedPenalty& edge, const Positions& shape,
										   int place) const {
	const Eigen::Vector3d d = displacement(shape, place);
	const double length = d.norm();
	if (length == 0)
		return Eigen::Matrix3d::Zero();
	const Eigen::Vector3d along = d / length;
	const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
	return masses_[place] / radius_ *
		   (edge.second(excess(d)) / radius_ * along * along.transpose() +
			edge.first(excess(d)) / length * across);
}

Positions DisplacementBound::within(const Positions& shape) const {
	Positions result = shape;
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		const Eigen::Vector3d d = displacement(shape, place);
		if (d.norm() > farthest_)
			result.col(place) = assembly_.originalPositions.col(place) + radius_ / d.norm() * d;
	}
	return result;
}

} // namespace developable::detail
