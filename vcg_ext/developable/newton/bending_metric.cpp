// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.cpp: puts the metric together, makes triangles stiffer, factorises.
#include "bending_metric.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// Where memory does not do for a factorisation: solutions are part of an operator, and have to be exact.
constexpr Iteration exactIteration = {1e-9, 5000};

} // namespace

BendingMetric::BendingMetric(const PatchAssembly& assembly, const NewtonTuning& tuning, double memoryLimit)
	: assembly_(assembly), tuning_(tuning), bending_(assembly), placeMass_(placeMasses(assembly)),
	  factorization_(memoryLimit, exactIteration) {}

void BendingMetric::takeOver(const BendingMetric& other) {
	bending_.takeOver(other.bending_);
	eliminationOrder_ = other.eliminationOrder_;
}

void BendingMetric::eliminateIn(std::vector<int> order) {
	eliminationOrder_ = std::move(order);
}

void BendingMetric::setSmoothness(const Smoothness& smoothness) {
	lower_ = bending_.lower(placeMass_, smoothness, tuning_.borderStiffness);
	diagonal_ = lower_.diagonal();
	stiffness_ = Eigen::VectorXd::Zero(assembly_.triangleCount());
	weight_ = placeMass_;
	loose_ = {};
}

void BendingMetric::stiffen(const std::vector<int>& triangles) {
	if (loose_.nonZeros() == 0 && !triangles.empty())
		loose_ = lower_;
	for (const int triangle : triangles) {
		const auto places = assembly_.trianglePlaces.col(triangle);
		const double before = stiffness_[triangle];
		stiffness_[triangle] = before > 0 ? tuning_.stiffnessIncrease * before
										  : tuning_.firstStiffness * diagonal_(places).maxCoeff();
		for (int corner = 0; corner < 3; ++corner)
			addSpring(places[corner], places[nextCorner(corner)], stiffness_[triangle] - before);
	}
}

bool BendingMetric::loosen() {
	if (loose_.nonZeros() == 0)
		return false;
	lower_.swap(loose_);
	loose_ = {};
	stiffness_.setZero();
	return true;
}

void BendingMetric::weigh(const Eigen::VectorXd& masses) {
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (!assembly_.placeFixed[place])
			for (SparseMatrix* matrix : {&lower_, &loose_})
				if (matrix->nonZeros() > 0)
					matrix->coeffRef(place, place) += masses[place];
	weight_ += masses;
}

bool BendingMetric::tooStiff() const {
	const auto stiff = (stiffness_.array() > 0).count();
	return stiff > std::max<double>(tuning_.stiffTriangles,
									tuning_.stiffShare * static_cast<double>(stiffness_.size()));
}

bool BendingMetric::factorize() {
	if (!factorization_.prepared())
		factorization_.prepare(lower_, eliminationOrder_);
	return factorization_.factorize(lower_);
}

Positions BendingMetric::apply(const Positions& displacement) const {
	Positions result = Positions::Zero(3, displacement.cols());
	for (int place = 0; place < lower_.outerSize(); ++place) {
		const Eigen::Vector3d own = displacement.col(place);
		Eigen::Vector3d sum = Eigen::Vector3d::Zero();
		for (SparseMatrix::InnerIterator entry(lower_, place); entry; ++entry) {
			result.col(entry.row()) += entry.value() * own;
			if (entry.row() != place)
				sum += entry.value() * displacement.col(entry.row());
		}
		result.col(place) += sum;
	}
	return result;
}

Positions BendingMetric::solve(const Positions& force) const {
	return factorization_.solve(Eigen::MatrixXd(force.transpose())).transpose();
}

double BendingMetric::squaredNorm(const Positions& displacement) const {
	return displacement.cwiseProduct(apply(displacement)).sum();
}

Positions BendingMetric::bendingForce(const Positions& positions, const Smoothness& smoothness) {
	return bending_.force(positions, smoothness, tuning_.borderStiffness);
}

void BendingMetric::addSpring(int i, int j, double stiffness) {
	for (const int place : {i, j})
		if (!assembly_.placeFixed[place])
			lower_.coeffRef(place, place) += stiffness;
	if (!assembly_.placeFixed[i] && !assembly_.placeFixed[j])
		lower_.coeffRef(std::max(i, j), std::min(i, j)) -= stiffness;
}

} // namespace developable::detail
