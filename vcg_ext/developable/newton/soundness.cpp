// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.cpp: spoilt triangles, and moves that spare them.
#include "soundness.h"

namespace developable::detail {

Soundness::Soundness(const PatchAssembly& assembly) : assembly_(assembly) {
	const double greatest = cornerCotangents(assembly, assembly.originalPositions).maxCoeff();
	const double leastAngle = std::min(std::atan2(1.0, greatest) / 2, 2 * pi / 180);
	greatestCotangent_ = 1 / std::tan(leastAngle * margin);
	const Eigen::Matrix3Xd normals = triangleNormals(assembly_, assembly.originalPositions);
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.joinedHalfEdge[halfEdge];
		if (across >= 0 && normals.col(halfEdge / 3).dot(normals.col(across / 3)) > 0)
			hinges_.push_back({halfEdge / 3, across / 3});
	}
}

std::vector<int> Soundness::spoiltTriangles(const Positions& positions) const {
	std::vector<int> spoilt;
	const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly_, positions);
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		if (!(cotangents.col(t).maxCoeff<Eigen::PropagateNaN>() <= greatestCotangent_))
			spoilt.push_back(t);
	const Eigen::Matrix3Xd normals = triangleNormals(assembly_, positions);
	for (const auto& [first, second] : hinges_)
		if (!(normals.col(first).dot(normals.col(second)) >= -0.5))
			spoilt.insert(spoilt.end(), {first, second});
	return spoilt;
}

bool Soundness::mend(const Positions& from, Positions& move) const {
	for (int round = 0; round < mendingRounds; ++round) {
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
