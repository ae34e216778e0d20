// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.cpp: puts the metric together, makes triangles stiffer, factorises.
#include "bending_metric.h"

#include "developable/geometry/geometry.h"

namespace developable::detail {

namespace {

/// Where memory does not do for a factorisation: solutions are part of an operator, and have to be exact.
constexpr Iteration exactIteration = {1e-9, 5000};

} // namespace

Eigen::VectorXd triangleAreas(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd areas(assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		areas[t] = triangleFrame(positions, assembly.trianglePlaces.col(t)).normal.norm() / 2;
	}
	return areas;
}

Eigen::VectorXd placeMasses(const PatchAssembly& assembly) {
	const Eigen::VectorXd areas = triangleAreas(assembly, assembly.originalPositions);
	Eigen::VectorXd masses = Eigen::VectorXd::Zero(assembly.placeCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (const int place : assembly.trianglePlaces.col(t))
			masses[place] += areas[t] / 3;
	return masses / areas.sum();
}

BendingMatrix::BendingMatrix(const PatchAssembly& assembly, const Eigen::VectorXd& masses,
							 const Eigen::VectorXd& smoothness)
	: assembly_(assembly), cotangents_(cornerCotangents(assembly, assembly.originalPositions)) {
	entries_.reserve(assembly.placeCount() + 10 * static_cast<std::size_t>(assembly.edgeCount()));
	for (int place = 0; place < assembly.placeCount(); ++place)
		entries_.emplace_back(place, place, masses[place]);
	addHinges(smoothness);
}

SparseMatrix BendingMatrix::lower() const {
	SparseMatrix result(assembly_.placeCount(), assembly_.placeCount());
	result.setFromTriplets(entries_.begin(), entries_.end());
	return result;
}

void BendingMatrix::addHinges(const Eigen::VectorXd& smoothness) {
	const Eigen::VectorXd areas = triangleAreas(assembly_, assembly_.originalPositions);
	const double area = areas.sum();
	Eigen::VectorXd patchArea = Eigen::VectorXd::Zero(assembly_.patchCount());
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		patchArea[assembly_.patchOfTriangle[t]] += areas[t];
	for (const int halfEdge : assembly_.edgeHalfEdge) {
		const int across = assembly_.across(halfEdge);
		if (across < 0)
			continue;
		const int patch = assembly_.patchOfTriangle[triangleOf(halfEdge)];
		addHinge(halfEdge, across,
				 smoothness[patch] * patchArea[patch] * patchArea[patch] /
					 (area * (areas[triangleOf(halfEdge)] + areas[triangleOf(across)])));
	}
}

void BendingMatrix::addHinge(int halfEdge, int across, double weight) {
	// Of each of the two triangles: the corners at the edge's ends, then the one opposite to it.
	int places[2][3];
	double cotangent[2][2];
	for (int side = 0; side < 2; ++side) {
		int corner = side ? across : halfEdge;
		for (int i = 0; i < 3; ++i, corner = nextCorner(corner)) {
			places[side][i] = assembly_.placeAt(corner);
			if (i < 2)
				cotangent[side][i] = cotangents_.data()[corner];
		}
	}
	const int same = places[0][0] == places[1][0] ? 0 : 1; // the second's corner at the first's first end
	const int place[4] = {places[0][0], places[0][1], places[0][2], places[1][2]};
	const double slope[4] = {cotangent[0][1] + cotangent[1][1 - same], cotangent[0][0] + cotangent[1][same],
							 -cotangent[0][0] - cotangent[0][1], -cotangent[1][0] - cotangent[1][1]};
	for (int i = 0; i < 4; ++i)
		for (int j = 0; j < 4; ++j)
			if (place[i] >= place[j] && !assembly_.placeFixed[place[i]] && !assembly_.placeFixed[place[j]])
				entries_.emplace_back(place[i], place[j], weight * slope[i] * slope[j]);
}

BendingMetric::BendingMetric(const PatchAssembly& assembly, const NewtonTuning& tuning, double memoryLimit)
	: assembly_(assembly), tuning_(tuning), placeMass_(placeMasses(assembly)),
	  factorization_(memoryLimit, exactIteration) {}

void BendingMetric::setSmoothness(const Eigen::VectorXd& smoothness) {
	lower_ = BendingMatrix(assembly_, placeMass_, smoothness).lower();
	diagonal_ = lower_.diagonal();
	stiffness_ = Eigen::VectorXd::Zero(assembly_.triangleCount());
	weight_ = placeMass_;
}

void BendingMetric::stiffen(const std::vector<int>& triangles) {
	for (const int triangle : triangles) {
		const auto places = assembly_.trianglePlaces.col(triangle);
		const double before = stiffness_[triangle];
		stiffness_[triangle] = before > 0 ? tuning_.stiffnessIncrease * before
										  : tuning_.firstStiffness * diagonal_(places).maxCoeff();
		for (int corner = 0; corner < 3; ++corner)
			addSpring(places[corner], places[nextCorner(corner)], stiffness_[triangle] - before);
	}
}

void BendingMetric::weigh(const Eigen::VectorXd& masses) {
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (!assembly_.placeFixed[place])
			lower_.coeffRef(place, place) += masses[place];
	weight_ += masses;
}

bool BendingMetric::tooStiff() const {
	const auto stiff = (stiffness_.array() > 0).count();
	return stiff > std::max<double>(tuning_.stiffTriangles,
									tuning_.stiffShare * static_cast<double>(stiffness_.size()));
}

bool BendingMetric::factorize() {
	return factorization_.factorize(lower_);
}

Positions BendingMetric::apply(const Positions& displacement) const {
	return (lower_.selfadjointView<Eigen::Lower>() * displacement.transpose()).transpose();
}

Positions BendingMetric::solve(const Positions& force) const {
	return factorization_.solve(Eigen::MatrixXd(force.transpose())).transpose();
}

double BendingMetric::squaredNorm(const Positions& displacement) const {
	return displacement.cwiseProduct(apply(displacement)).sum();
}

void BendingMetric::addSpring(int i, int j, double stiffness) {
	for (const int place : {i, j})
		if (!assembly_.placeFixed[place])
			lower_.coeffRef(place, place) += stiffness;
	if (!assembly_.placeFixed[i] && !assembly_.placeFixed[j])
		lower_.coeffRef(std::max(i, j), std::min(i, j)) -= stiffness;
}

} // namespace developable::detail
