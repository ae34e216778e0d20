// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.cpp: puts the metric together, makes triangles stiffer, factorises.
#include "bending_metric.h"

#include "developable/geometry/geometry.h"
#include "fitted_hessian.h"
#include "rods.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

/// Where memory does not do for a factorisation: solutions are part of an operator, and have to be exact.
constexpr Iteration exactIteration = {1e-9, 5000};

constexpr int trianglesInARun = 8192; ///< of which one thread finds the bending
constexpr int runsAtOnce = 8;

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
							 const Smoothness& smoothness, double rods)
	: assembly_(assembly), areas_(triangleAreas(assembly, assembly.originalPositions)),
	  partArea_(partAreas(assembly, areas_)) {
	entries_.reserve(assembly.placeCount() + 21 * static_cast<std::size_t>(assembly.triangleCount()));
	for (int place = 0; place < assembly.placeCount(); ++place)
		entries_.emplace_back(place, place, masses[place]);
	addPlates(smoothness);
	if (rods > 0)
		addRods(smoothness, rods);
}

SparseMatrix BendingMatrix::lower() const {
	SparseMatrix result(assembly_.placeCount(), assembly_.placeCount());
	result.setFromTriplets(entries_.begin(), entries_.end());
	return result;
}

void BendingMatrix::addPlates(const Smoothness& smoothness) {
	Eigen::VectorXd patchArea = Eigen::VectorXd::Zero(assembly_.patchCount());
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		patchArea[assembly_.patchOfTriangle[t]] += areas_[t];
	Eigen::VectorXd ofPart(assembly_.patchCount());
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		ofPart[assembly_.patchOfTriangle[t]] = partArea_[assembly_.trianglePlaces(0, t)];
	const Eigen::VectorXd weights = (smoothness.ofPatches.array() * patchArea.array() * patchArea.array() +
									 smoothness.ofPart * ofPart.array() * ofPart.array()) /
									areas_.sum();
	const FittedHessian hessian(assembly_, areas_);
	const auto findRun = [&](int begin, std::vector<Entry>& entries) {
		const int end = std::min(begin + trianglesInARun, assembly_.triangleCount());
		for (int t = begin; t < end; ++t) {
			const TriangleBending bending = hessian.bending(t);
			addSquares(bending.places, bending.rows, weights[assembly_.patchOfTriangle[t]], entries);
		}
	};
	for (int first = 0; first < assembly_.triangleCount(); first += runsAtOnce * trianglesInARun) {
		std::vector<std::vector<Entry>> entries(runsAtOnce);
		std::vector<Task> tasks;
		for (int run = 0, begin = first; run < runsAtOnce && begin < assembly_.triangleCount(); ++run) {
			tasks.push_back({1, [&, run, begin](const Progress&) { findRun(begin, entries[run]); }});
			begin += trianglesInARun;
		}
		runTasks(tasks, 0, {});
		for (const std::vector<Entry>& ofRun : entries)
			entries_.insert(entries_.end(), ofRun.begin(), ofRun.end());
	}
}

void BendingMatrix::addRods(const Smoothness& smoothness, double rods) {
	const double wholeArea = areas_.sum();
	Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(assembly_.placeCount()); // β
	for (int copy = 0; copy < assembly_.copyCount(); ++copy) {
		double& ofPlace = stiffness[assembly_.placeOfCopy[copy]];
		ofPlace =
			std::max(ofPlace, rods * (smoothness.ofPatches[assembly_.patchOfCopy[copy]] + smoothness.ofPart));
	}
	for (const RodJoint& joint : rodJoints(assembly_, {}))
		addSquares({joint.begin(), joint.end()}, rodBending(assembly_, joint).transpose(),
				   stiffness[joint[1]] * std::pow(partArea_[joint[1]], 2.5) / wholeArea, entries_);
}

template <class Rows>
void BendingMatrix::addSquares(const std::vector<int>& places, const Rows& rows, double weight,
							   std::vector<Entry>& entries) const {
	for (std::size_t i = 0; i < places.size(); ++i)
		for (std::size_t j = 0; j < places.size(); ++j)
			if (places[i] >= places[j] && !assembly_.placeFixed[places[i]] &&
				!assembly_.placeFixed[places[j]])
				entries.emplace_back(places[i], places[j], weight * rows.col(i).dot(rows.col(j)));
}

BendingMetric::BendingMetric(const PatchAssembly& assembly, const NewtonTuning& tuning, double memoryLimit)
	: assembly_(assembly), tuning_(tuning), placeMass_(placeMasses(assembly)),
	  factorization_(memoryLimit, exactIteration) {}

void BendingMetric::setSmoothness(const Smoothness& smoothness) {
	lower_ = BendingMatrix(assembly_, placeMass_, smoothness, tuning_.borderStiffness).lower();
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

Positions BendingMetric::bendingForce(const Positions& positions, const Smoothness& smoothness) const {
	PatchAssembly free = assembly_;
	free.placeFixed.assign(free.placeCount(), 0);
	const SparseMatrix bending =
		BendingMatrix(free, Eigen::VectorXd::Zero(free.placeCount()), smoothness, tuning_.borderStiffness)
			.lower();
	Positions force = (bending.selfadjointView<Eigen::Lower>() * positions.transpose()).transpose();
	for (int place = 0; place < free.placeCount(); ++place)
		if (assembly_.placeFixed[place])
			force.col(place).setZero();
	return force;
}

void BendingMetric::addSpring(int i, int j, double stiffness) {
	for (const int place : {i, j})
		if (!assembly_.placeFixed[place])
			lower_.coeffRef(place, place) += stiffness;
	if (!assembly_.placeFixed[i] && !assembly_.placeFixed[j])
		lower_.coeffRef(std::max(i, j), std::min(i, j)) -= stiffness;
}

} // namespace developable::detail
