// SPDX-License-Identifier: GPL-3.0-or-later
// strain_penalty.cpp: the cost of one triangle, and sums over them.
#include "strain_penalty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace developable {

namespace {

Eigen::Matrix3d cornersOf(const Positions& positions, const Eigen::Vector3i& corners) {
	return positions(Eigen::all, corners);
}

/// The derivatives of F : M for a constant M, by the last so many of the coordinates of the shape's corners
/// and the pattern's.
template <int size>
Eigen::Matrix<double, size, 1> derivativesOfMap(const TriangleStrain& strain,
												const Eigen::Matrix<double, 3, 2>& m) {
	// dF = (dX − F dU) U⁻¹ with X and U the edges from the first corner.
	const Eigen::Matrix<double, 3, 2> byShape = m * strain.inverseFlatEdges.transpose();
	const Eigen::Matrix2d byPattern = -strain.map.transpose() * byShape;
	Eigen::Matrix<double, size, 1> result;
	if constexpr (size == 15)
		result.template head<9>() << -byShape.rowwise().sum(), byShape.col(0), byShape.col(1);
	result.template tail<6>() << -byPattern.rowwise().sum(), byPattern.col(0), byPattern.col(1);
	return result;
}

/// The derivatives of X : M for the edges X of the shape, and of U : M for those of the pattern.
Eigen::Matrix<double, 15, 1> derivativesOfShape(const Eigen::Matrix<double, 3, 2>& m) {
	Eigen::Matrix<double, 15, 1> result = Eigen::Matrix<double, 15, 1>::Zero();
	result.head<9>() << -m.rowwise().sum(), m.col(0), m.col(1);
	return result;
}
template <int size>
Eigen::Matrix<double, size, 1> derivativesOfPattern(const Eigen::Matrix2d& m) {
	Eigen::Matrix<double, size, 1> result = Eigen::Matrix<double, size, 1>::Zero();
	result.template tail<6>() << -m.rowwise().sum(), m.col(0), m.col(1);
	return result;
}

/// What the second derivatives gain because the principal directions turn with the shear between them, as a
/// factor of the squared derivative of that shear: with s₁ = σ1², s₂ = σ2² and the derivatives p₁', p₂' of
/// the cost by the strains, (p₁'/s₁ − p₂'/s₂) / (s₁ − s₂), never negative.
double gainOfTurning(const TriangleStrain& strain, double firstSlope, double secondSlope, double curvature) {
	const double s1 = strain.greatest * strain.greatest, s2 = strain.least * strain.least;
	constexpr double sameStrains = 1e-7; // the limit serves where the quotient would be rounding
	const double gain = s1 - s2 > sameStrains * s1 ? (firstSlope / s1 - secondSlope / s2) / (s1 - s2)
												   : (curvature / 2 - firstSlope) / (s1 * s1);
	return std::max(gain, 0.0);
}

} // namespace

StrainPenalty::StrainPenalty(StrainedTriangles triangles, const StrainBounds& bounds, double elasticity)
	: triangles_(std::move(triangles)), directed_(differs(bounds).stretch || differs(bounds).compression),
	  ofPrincipal_(limitsOf(bounds.warp, {!differs(bounds).stretch, !differs(bounds).compression},
							directed_ ? 0 : elasticity)),
	  // along two directions and both between them: twice as many as the principal ones
	  ofWarp_(limitsOf(bounds.warp, differs(bounds), elasticity / 2)),
	  ofWeft_(limitsOf(bounds.weft, differs(bounds), elasticity / 2)),
	  ofBias_(limitsOf(bounds.bias, differs(bounds), elasticity / 2)) {
	setGrain(std::move(triangles_.grain));
}

StrainPenalty::Signs StrainPenalty::differs(const StrainBounds& bounds) {
	return {!bounds.sameInEveryDirection(&DirectionBounds::stretch),
			!bounds.sameInEveryDirection(&DirectionBounds::compression)};
}

StrainPenalty::Limits StrainPenalty::limitsOf(const DirectionBounds& bounds, const Signs& bounded,
											  double elasticity) {
	constexpr double none = std::numeric_limits<double>::infinity();
	return {bounded.compression ? std::log(1 - bounds.compression) : -none,
			bounded.stretch ? std::log(1 + bounds.stretch) : none, elasticity};
}

void StrainPenalty::setGrain(std::vector<double> grain) {
	triangles_.grain = std::move(grain);
	warp_.clear();
	for (const double angle : triangles_.grain)
		warp_.emplace_back(std::cos(angle), std::sin(angle));
}

TriangleStrain StrainPenalty::strain(int triangle, const Positions& shaped,
									 const Eigen::Matrix2Xd& flat) const {
	return {cornersOf(shaped, triangles_.shaped.col(triangle)),
			flat(Eigen::all, triangles_.flat.col(triangle))};
}

StrainPenalty::Directions StrainPenalty::directions(int triangle, const TriangleStrain& strain) const {
	Directions result;
	if (ofPrincipal_.any()) {
		const Eigen::Vector2d& first = strain.greatestDirection;
		result.add(first, ofPrincipal_);
		result.add({-first[1], first[0]}, ofPrincipal_);
	}
	if (directed_) {
		const Eigen::Vector2d& warp = warp_[triangle];
		const Eigen::Vector2d weft(-warp[1], warp[0]);
		result.add(warp, ofWarp_);
		result.add(weft, ofWeft_);
		result.add((warp + weft) / std::sqrt(2.0), ofBias_);
		result.add((warp - weft) / std::sqrt(2.0), ofBias_);
	}
	return result;
}

double StrainPenalty::cost(const TriangleStrain& strain, const Directions& directions) const {
	double elastic = 0;
	RoundedPenalty::Sum beyond(edge_);
	for (const auto& [vector, limits] : directions) {
		const double e = std::log((strain.map * vector).squaredNorm()) / 2;
		elastic += limits->elasticity * e * e / 2;
		if (std::isfinite(limits->greatest))
			beyond.add(e - limits->greatest);
		if (std::isfinite(limits->least))
			beyond.add(limits->least - e);
	}
	return elastic + beyond.value();
}

StrainPenalty::Slope StrainPenalty::slope(const Limits& limits, double strain) const {
	Slope slope = {limits.elasticity * strain, limits.elasticity};
	if (std::isfinite(limits.greatest)) {
		const double above = strain - limits.greatest;
		slope.first += edge_.first(above);
		slope.second += edge_.second(above);
	}
	if (std::isfinite(limits.least)) {
		const double below = limits.least - strain;
		slope.first -= edge_.first(below);
		slope.second += edge_.second(below);
	}
	return slope;
}

double StrainPenalty::value(const Positions& shaped, const Eigen::Matrix2Xd& flat) const {
	double sum = triangles_.fans.value(edge_, flat);
	for (int t = 0; t < triangles_.count(); ++t) {
		const TriangleStrain triangle = strain(t, shaped, flat);
		if (!(triangle.flatArea > 0) || !(triangle.least > 0))
			return std::numeric_limits<double>::infinity();
		sum += triangles_.weights[t] * cost(triangle, directions(t, triangle));
	}
	return sum;
}

StrainPenalty::Element StrainPenalty::element(int t, const Positions& shaped,
											  const Eigen::Matrix2Xd& flat) const {
	return derivatives<15>(t, shaped, flat);
}

StrainPenalty::FlatElement StrainPenalty::flatElement(int t, const Positions& shaped,
													  const Eigen::Matrix2Xd& flat) const {
	return derivatives<6>(t, shaped, flat);
}

template <int size>
StrainPenalty::Derivatives<size> StrainPenalty::derivatives(int t, const Positions& shaped,
															const Eigen::Matrix2Xd& flat) const {
	const TriangleStrain triangle = strain(t, shaped, flat);
	const Eigen::Vector3d normal =
		Eigen::Vector3d(triangle.map.col(0)).cross(Eigen::Vector3d(triangle.map.col(1))).normalized();
	using Row = Eigen::Matrix<double, size, 1>;
	Derivatives<size> element;
	const auto add = [&](const Row& row, double second) {
		const Row scaled = second * row;
		element.hessian.noalias() += scaled * row.transpose(); // for so few rows faster than a half of it
	};
	if (ofPrincipal_.any()) {
		const Slope first = slope(ofPrincipal_, std::log(triangle.greatest)),
					second = slope(ofPrincipal_, std::log(triangle.least));
		const double gain = gainOfTurning(triangle, first.first, second.first, first.second);
		const Eigen::Vector2d v = triangle.greatestDirection, across(-v[1], v[0]);
		const Eigen::Matrix2d shear = v * across.transpose() + across * v.transpose();
		add(derivativesOfMap<size>(triangle, triangle.map * shear), triangles_.weights[t] * gain);
	}
	for (const Direction& direction : directions(t, triangle)) {
		const Eigen::Vector3d image = triangle.map * direction.vector;
		const double length = image.norm();
		const Eigen::Vector3d unit = image / length;
		const Slope cost = slope(*direction.limits, std::log(length));
		const double weight = triangles_.weights[t];
		const Row row = derivativesOfMap<size>(triangle, unit * direction.vector.transpose() / length);
		element.gradient += weight * cost.first * row;
		add(row, weight * cost.second);
		// A tension resists that the shape is turned, a compression that the pattern is.
		const Eigen::Vector2d along = triangle.inverseFlatEdges * direction.vector;
		const Eigen::Vector2d across(-direction.vector[1], direction.vector[0]);
		const double turning = weight * std::abs(cost.first);
		if (cost.first < 0)
			add(derivativesOfPattern<size>(across * along.transpose()), turning);
		else if constexpr (size == 15)
			for (const Eigen::Vector3d& side : {normal, Eigen::Vector3d(normal.cross(unit))})
				add(derivativesOfShape(side * along.transpose() / length), turning);
	}
	return element;
}

Eigen::VectorXd StrainPenalty::violations(const Positions& shaped, const Eigen::Matrix2Xd& flat) const {
	Eigen::VectorXd result = Eigen::VectorXd::Zero(triangles_.count());
	for (int t = 0; t < triangles_.count(); ++t) {
		const TriangleStrain triangle = strain(t, shaped, flat);
		for (const Direction& direction : directions(t, triangle)) {
			const double length = (triangle.map * direction.vector).norm();
			result[t] = std::max({result[t], length - std::exp(direction.limits->greatest),
								  std::exp(direction.limits->least) - length});
		}
	}
	return result;
}

Eigen::Matrix2Xd principalStrains(const StrainedTriangles& triangles, const Positions& shaped,
								  const Eigen::Matrix2Xd& flat) {
	Eigen::Matrix2Xd result(2, triangles.count());
	for (int t = 0; t < triangles.count(); ++t) {
		const TriangleStrain strain(cornersOf(shaped, triangles.shaped.col(t)),
									flat(Eigen::all, triangles.flat.col(t)));
		result.col(t) << strain.greatest, strain.least;
	}
	return result;
}

} // namespace developable
