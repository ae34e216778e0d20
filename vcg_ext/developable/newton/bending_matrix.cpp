// SPDX-License-Identifier: GPL-3.0-or-later
// bending_matrix.cpp: masses, plates and rods, put together.
#include "bending_matrix.h"

#include "developable/geometry/geometry.h"
#include "fitted_hessian.h"
#include "rods.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

constexpr int trianglesInARun = 8192; ///< of which one thread finds the bending
constexpr int runsAtOnce = 8;
constexpr double roundingOfWeights = 1e-12; ///< of weights of plates

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

BendingMatrix::BendingMatrix(const PatchAssembly& assembly)
	: assembly_(assembly), areas_(triangleAreas(assembly, assembly.originalPositions)),
	  partArea_(partAreas(assembly, areas_)) {}

SparseMatrix BendingMatrix::lower(const Eigen::VectorXd& masses, const Smoothness& smoothness, double rods) {
	SparseMatrix result = plates(smoothness);
	for (int place = 0; place < assembly_.placeCount(); ++place)
		result.valuePtr()[result.outerIndexPtr()[place]] += masses[place]; // the diagonal comes first
	if (rods > 0)
		result += this->rods(smoothness, rods);
	return result;
}

Positions BendingMatrix::force(const Positions& positions, const Smoothness& smoothness, double rods) {
	if (!holdsPlaces(assembly_)) {
		const SparseMatrix bending = lower(Eigen::VectorXd::Zero(assembly_.placeCount()), smoothness, rods);
		return (bending.selfadjointView<Eigen::Lower>() * positions.transpose()).transpose();
	}
	PatchAssembly free = assembly_;
	free.placeFixed.assign(free.placeCount(), 0);
	Positions result = BendingMatrix(free).force(positions, smoothness, rods);
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (assembly_.placeFixed[place])
			result.col(place).setZero();
	return result;
}

/// Weights that are a multiple of those with α = 1 in every patch, as most are, take no more than that
/// multiple of what was found once.
SparseMatrix BendingMatrix::plates(const Smoothness& smoothness) {
	Eigen::ArrayXd patchArea = Eigen::ArrayXd::Zero(assembly_.patchCount());
	Eigen::ArrayXd partArea(assembly_.patchCount());
	for (int t = 0; t < assembly_.triangleCount(); ++t) {
		patchArea[assembly_.patchOfTriangle[t]] += areas_[t];
		partArea[assembly_.patchOfTriangle[t]] = partArea_[assembly_.trianglePlaces(0, t)];
	}
	const Eigen::ArrayXd unit = patchArea.square() / areas_.sum();
	const Eigen::ArrayXd weights =
		(smoothness.ofPatches.array() * patchArea.square() + smoothness.ofPart * partArea.square()) /
		areas_.sum();
	if ((weights == 0).all())
		return plates();
	const double multiple = weights[0] / unit[0];
	if (((weights - multiple * unit).abs() > roundingOfWeights * weights).any())
		return plates(Eigen::VectorXd(weights));
	if (!unitPlates_)
		unitPlates_ = std::make_shared<const SparseMatrix>(plates(Eigen::VectorXd(unit)));
	return multiple * *unitPlates_;
}

/// None, with entries for what is stiffer later.
SparseMatrix BendingMatrix::plates() const {
	std::vector<Entry> entries;
	entries.reserve(assembly_.placeCount() + 3 * static_cast<std::size_t>(assembly_.triangleCount()));
	for (int place = 0; place < assembly_.placeCount(); ++place)
		entries.emplace_back(place, place, 0);
	for (const auto places : assembly_.trianglePlaces.colwise())
		for (int corner = 0; corner < 3; ++corner) {
			const int a = places[corner], b = places[nextCorner(corner)];
			entries.emplace_back(std::max(a, b), std::min(a, b), 0);
		}
	return sum(entries);
}

/// \param weights  per patch, of ∫|d''|²
SparseMatrix BendingMatrix::plates(const Eigen::VectorXd& weights) const {
	std::vector<Entry> all;
	all.reserve(assembly_.placeCount() + 21 * static_cast<std::size_t>(assembly_.triangleCount()));
	for (int place = 0; place < assembly_.placeCount(); ++place)
		all.emplace_back(place, place, 0);
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
			all.insert(all.end(), ofRun.begin(), ofRun.end());
	}
	return sum(all);
}

SparseMatrix BendingMatrix::rods(const Smoothness& smoothness, double rods) const {
	const double wholeArea = areas_.sum();
	Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(assembly_.placeCount()); // β
	for (int copy = 0; copy < assembly_.copyCount(); ++copy) {
		double& ofPlace = stiffness[assembly_.placeOfCopy[copy]];
		ofPlace =
			std::max(ofPlace, rods * (smoothness.ofPatches[assembly_.patchOfCopy[copy]] + smoothness.ofPart));
	}
	std::vector<Entry> entries;
	for (const RodJoint& joint : rodJoints(assembly_, {}))
		addSquares({joint.begin(), joint.end()}, rodBending(assembly_, joint).transpose(),
				   stiffness[joint[1]] * std::pow(partArea_[joint[1]], 2.5) / wholeArea, entries);
	return sum(entries);
}

SparseMatrix BendingMatrix::sum(const std::vector<Entry>& entries) const {
	SparseMatrix result(assembly_.placeCount(), assembly_.placeCount());
	result.setFromTriplets(entries.begin(), entries.end());
	return result;
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

} // namespace developable::detail
