// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.cpp: puts the metric together, makes triangles stiffer, factorises.
#include "bending_metric.h"

namespace developable::detail {

Eigen::VectorXd triangleAreas(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd areas(assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		areas[t] = TriangleFrame(positions.col(places[0]), positions.col(places[1]), positions.col(places[2]))
					   .normal.norm() /
				   2;
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
		const int across = assembly_.joinedHalfEdge[halfEdge];
		if (across < 0)
			continue;
		const int patch = assembly_.patchOfTriangle[halfEdge / 3];
		addHinge(halfEdge, across,
				 smoothness[patch] * patchArea[patch] * patchArea[patch] /
					 (area * (areas[halfEdge / 3] + areas[across / 3])));
	}
}

void BendingMatrix::addHinge(int halfEdge, int across, double weight) {
	// Of each of the two triangles: the corners at the edge's ends, then the one opposite to it.
	int places[2][3];
	double cotangent[2][2];
	for (int side = 0; side < 2; ++side) {
		const int triangle = (side ? across : halfEdge) / 3, first = (side ? across : halfEdge) % 3;
		for (int i = 0; i < 3; ++i)
			places[side][i] = assembly_.trianglePlaces((first + i) % 3, triangle);
		for (int i = 0; i < 2; ++i)
			cotangent[side][i] = cotangents_((first + i) % 3, triangle);
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

void BendingMetric::stiffen(const std::vector<int>& triangles) {
	for (const int triangle : triangles) {
		const auto places = assembly_.trianglePlaces.col(triangle);
		const double before = stiffness_[triangle];
		stiffness_[triangle] = before > 0 ? 4 * before : 0.1 * diagonal_(places).maxCoeff();
		for (int corner = 0; corner < 3; ++corner)
			tie(places[corner], places[(corner + 1) % 3], stiffness_[triangle] - before);
	}
}

bool BendingMetric::tooStiff() const {
	const auto stiff = (stiffness_.array() > 0).count();
	return stiff > std::max(20.0, 0.1 * static_cast<double>(stiffness_.size()));
}

void BendingMetric::factorize() {
	if (!factorization_.factorize(lower_))
		throw DegenerateTriangle("Some faces are too thin to compute with: remove needle-like faces first.");
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

void BendingMetric::tie(int i, int j, double stiffness) {
	if (assembly_.placeFixed[i] || assembly_.placeFixed[j])
		return;
	const int column = std::min(i, j), row = std::max(i, j);
	for (SparseMatrix::InnerIterator entry(lower_, column); entry; ++entry)
		if (entry.row() == row) {
			entry.valueRef() -= stiffness;
			lower_.coeffRef(i, i) += stiffness;
			lower_.coeffRef(j, j) += stiffness;
		}
}

} // namespace developable::detail
