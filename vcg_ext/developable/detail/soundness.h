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

	bool holds(const Positions& positions) const {
		if (!(cornerCotangents(assembly_, positions).maxCoeff<Eigen::PropagateNaN>() <= greatestCotangent_))
			return false;
		const Eigen::Matrix3Xd normals = triangleNormals(assembly_, positions);
		return std::all_of(hinges_.begin(), hinges_.end(), [&](const auto& hinge) {
			return normals.col(hinge.first).dot(normals.col(hinge.second)) >= -0.5;
		});
	}

private:
	static constexpr double margin = 1.01; ///< for what rounding to the host's scalar may take away

	const PatchAssembly& assembly_;
	double greatestCotangent_ = 0;
	std::vector<std::pair<int, int>> hinges_; // pairs of neighbouring triangles that could flip
};

} // namespace developable::detail
