// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.h: whether a shape has kept its triangles in order: none flipped, none become a sliver.
#pragma once

#include "developable/mesh/mesh.h"
#include "newton_tuning.h"

namespace developable::detail {

/// Compares shapes with the original. A triangle is flipped when its normal makes an angle of more than 120°
/// with that of an edge neighbour with which it made less than 90°; it is a sliver when one of its angles is
/// less than half of the smallest of the original, or than 2° if that is less (see NewtonTuning).
class Soundness {
public:
	Soundness(const PatchAssembly& assembly, const NewtonTuning& tuning);

	bool holds(const Positions& positions) const { return spoiltTriangles(positions).empty(); }

	/// The triangles that are slivers, and every flipped one with its neighbour.
	std::vector<int> spoiltTriangles(const Positions& positions) const;

	/// Changes a move such that it leaves a sound shape sound: a triangle that it would spoil moves as one
	/// piece, by the mean of what its corners would; what is held still stays so. \return whether that did
	/// within some rounds
	bool spare(const Positions& from, Positions& move) const;

private:
	/// Two neighbouring triangles that could flip. Their orientations are compared across their edge, so that
	/// it does not matter whether a patch has two sides.
	struct Hinge {
		int first, second;
		double sameSide; ///< -1 where the triangles run round oppositely, else 1
	};

	class Inspection;

	bool isSliver(const Eigen::Vector3d& cotangents) const;
	static bool isFlipped(const Hinge& hinge, const Eigen::Matrix3Xd& normals);
	void moveAsOne(const Eigen::Vector3i& places, Positions& move) const;

	const PatchAssembly& assembly_;
	double greatestCotangent_ = 0;
	std::vector<Hinge> hinges_; // pairs that made less than 90°
	int sparingRounds_;
};

} // namespace developable::detail
