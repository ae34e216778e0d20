// SPDX-License-Identifier: GPL-3.0-or-later
// bending_bound.cpp: a sum over the vertex copies, each by the second derivatives there.
#include "bending_bound.h"

#include <cmath>

namespace developable::detail {

namespace {

constexpr double clearance = 0.03; ///< share of the limit by which radii keep away from it
constexpr double unfelt = 20;      ///< widths below the limit, where the cost has next to no slope

/// Of the area, per copy.
Eigen::VectorXd copyShares(const PatchAssembly& assembly) {
	const Eigen::VectorXd areas = copyAreas(assembly, assembly.originalPositions);
	return areas / areas.sum();
}

} // namespace

BendingBound::BendingBound(const PatchAssembly& assembly, const BendingLimit& limit)
	: assembly_(assembly), radius_((1 + clearance) * limit.radius), force_(limit.force),
	  masses_(copyShares(assembly)) {}

void BendingBound::take(const Positions& shape) {
	if (radius_ > 0)
		derivatives_ = secondDerivatives(assembly_, shape);
}

double BendingBound::value(const Positions& shape) const {
	double sum = 0;
	for (std::size_t copy = 0; copy < derivatives_.size(); ++copy)
		sum += masses_[copy] * slope(bent(derivatives_[copy], shape).norm() - 1).value;
	return sum;
}

void BendingBound::addDerivatives(const Positions& shape, Eigen::VectorXd& gradient, Entries& entries) const {
	for (std::size_t copy = 0; copy < derivatives_.size(); ++copy) {
		const SecondDerivatives& at = derivatives_[copy];
		const Vector9 curved = bent(at, shape);
		const double norm = curved.norm();
		if (norm == 0 || norm - 1 < -unfelt * width_)
			continue;
		const Slope cost = slope(norm - 1);
		const Vector9 along = curved / norm;
		const Vector9 force = masses_[copy] * cost.first * along;
		for (std::size_t i = 0; i < at.places.size(); ++i)
			if (!assembly_.placeFixed[at.places[i]])
				gradient.segment<3>(3 * at.places[i]) +=
					force.reshaped(3, 3) * (radius_ * at.rows.col(Eigen::Index(i)));
		const double across = cost.first / norm;
		addHessian(at,
				   masses_[copy] *
					   (across * Matrix9::Identity() + (cost.second - across) * along * along.transpose()),
				   entries);
	}
}

void BendingBound::addHessian(const SecondDerivatives& at, const Matrix9& hessian, Entries& entries) const {
	const Eigen::Matrix3Xd rows = radius_ * at.rows;
	for (std::size_t i = 0; i < at.places.size(); ++i) {
		if (assembly_.placeFixed[at.places[i]])
			continue;
		const auto byRow = rows.col(Eigen::Index(i));
		const Eigen::Matrix<double, 3, 9> part = byRow[0] * hessian.topRows<3>() +
												 byRow[1] * hessian.middleRows<3>(3) +
												 byRow[2] * hessian.bottomRows<3>();
		for (std::size_t j = 0; j < at.places.size(); ++j) {
			if (at.places[j] > at.places[i] || assembly_.placeFixed[at.places[j]])
				continue;
			const auto byColumn = rows.col(Eigen::Index(j));
			const Eigen::Matrix3d block = byColumn[0] * part.leftCols<3>() +
										  byColumn[1] * part.middleCols<3>(3) +
										  byColumn[2] * part.rightCols<3>();
			for (int row = 0; row < 3; ++row)
				for (int column = 0; column < (at.places[j] == at.places[i] ? row + 1 : 3); ++column)
					entries.emplace_back(3 * at.places[i] + row, 3 * at.places[j] + column,
										 block(row, column));
		}
	}
}

BendingBound::Vector9 BendingBound::bent(const SecondDerivatives& at, const Positions& shape) const {
	Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
	for (std::size_t i = 0; i < at.places.size(); ++i)
		result += shape.col(at.places[i]) * at.rows.col(Eigen::Index(i)).transpose();
	return radius_ * result.reshaped();
}

BendingBound::Slope BendingBound::slope(double excess) const {
	const double square = width_ * width_, root = std::sqrt(excess * excess + square);
	const double sum = excess > 0 ? excess + root : square / (root - excess); // without a loss of digits
	return {force_ / 2 * sum, force_ / 2 * sum / root, force_ / 2 * square / (root * root * root)};
}

} // namespace developable::detail
