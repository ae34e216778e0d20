// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.h: whether a shape has kept its triangles in order: none flipped, none become a sliver.
#pragma once

#include "../angle_defect.h"
#include "vertex_normals.h"

namespace developable::detail {

/// Compares shapes with the original. A triangle is flipped when its normal makes an angle of more than 120°
/// with that of an edge neighbour with which it made less than 90°; it is a sliver when one of its angles is
/// less than half of the smallest of the original, or than 2° if that is less.
class Soundness {
public:
	explicit Soundness(const PatchAssembly& assembly) : assembly_(assembly) {
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

	bool holds(const Positions& positions) const { return spoiltTriangles(positions).empty(); }

	/// The triangles that are slivers, and every flipped one with its neighbour.
	std::vector<int> spoiltTriangles(const Positions& positions) const {
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

	/// Changes a move such that it leaves a sound shape sound: a triangle that it would spoil moves as one
	/// piece, by the mean of what its corners would; what is held still stays so. \return whether that did
	bool mend(const Positions& from, Positions& move) const {
		for (int round = 0; round < mendingRounds; ++round) {
			const std::vector<int> spoilt = spoiltTriangles(from + move);
			if (spoilt.empty())
				return true;
			for (const int triangle : spoilt)
				moveAsOne(assembly_.trianglePlaces.col(triangle), move);
		}
		return false;
	}

private:
	static constexpr int mendingRounds = 20;
	static constexpr double margin = 1.01; ///< for what rounding to the host's scalar may take away

	void moveAsOne(const Eigen::Vector3i& places, Positions& move) const {
		const Eigen::Vector3d mean = (move.col(places[0]) + move.col(places[1]) + move.col(places[2])) / 3;
		for (const int place : places)
			if (!assembly_.placeFixed[place])
				move.col(place) = mean;
	}

	const PatchAssembly& assembly_;
	double greatestCotangent_ = 0;
	std::vector<std::pair<int, int>> hinges_; // pairs of neighbouring triangles that could flip
};

} // namespace developable::detail
