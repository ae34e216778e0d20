// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.cpp: spoilt triangles, and moves that spare them.
#include "soundness.h"

#include "developable/geometry/geometry.h"

namespace developable::detail {

namespace {

constexpr double flipCosine = -0.5; ///< of the angle between neighbours' normals beyond which one is flipped

} // namespace

Soundness::Soundness(const PatchAssembly& assembly, const NewtonTuning& tuning)
	: assembly_(assembly), sparingRounds_(tuning.sparingRounds) {
	const double greatest = cornerCotangents(assembly, assembly.originalPositions).maxCoeff();
	const double leastAngle =
		std::min(std::atan2(1.0, greatest) * tuning.sliverShare, tuning.sliverAngle * pi / 180);
	greatestCotangent_ = 1 / std::tan(leastAngle * tuning.sliverMargin);
	const Eigen::Matrix3Xd normals = unitNormals(assembly, assembly.originalPositions);
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.across(halfEdge);
		if (across < 0)
			continue;
		const Hinge hinge{triangleOf(halfEdge), triangleOf(across),
						  assembly.copyAt(halfEdge) == assembly.copyAt(across) ? -1.0 : 1.0};
		if (hinge.sameSide * normals.col(hinge.first).dot(normals.col(hinge.second)) > 0)
			hinges_.push_back(hinge);
	}
}

std::vector<int> Soundness::spoiltTriangles(const Positions& positions) const {
	std::vector<int> spoilt;
	const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly_, positions);
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		if (!(cotangents.col(t).maxCoeff<Eigen::PropagateNaN>() <= greatestCotangent_))
			spoilt.push_back(t);
	const Eigen::Matrix3Xd normals = unitNormals(assembly_, positions);
	for (const auto& [first, second, sameSide] : hinges_)
		if (!(sameSide * normals.col(first).dot(normals.col(second)) >= flipCosine))
			spoilt.insert(spoilt.end(), {first, second});
	return spoilt;
}

bool Soundness::spare(const Positions& from, Positions& move) const {
	for (int round = 0; round < sparingRounds_; ++round) {
		const std::vector<int> spoilt = spoiltTriangles(from + move);
		if (spoilt.empty())
			return true;
		for (const int triangle : spoilt)
			moveAsOne(assembly_.trianglePlaces.col(triangle), move);
	}
	return false;
}

void Soundness::moveAsOne(const Eigen::Vector3i& places, Positions& move) const {
	const Eigen::Vector3d mean = (move.col(places[0]) + move.col(places[1]) + move.col(places[2])) / 3;
	for (const int place : places)
		if (!assembly_.placeFixed[place])
			move.col(place) = mean;
}

} // namespace developable::detail
