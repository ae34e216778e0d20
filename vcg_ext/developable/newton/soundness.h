// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.h: whether a shape has kept its triangles in order: none flipped, none become a sliver.
#pragma once

#include "developable/geometry/geometry.h"

namespace developable::detail {

/// Compares shapes with the original. A triangle is flipped when its normal makes an angle of more than 120°
/// with that of an edge neighbour with which it made less than 90°; it is a sliver when one of its angles is
/// less than half of the smallest of the original, or than 2° if that is less.
class Soundness {
public:
	explicit Soundness(const PatchAssembly& assembly);

	bool holds(const Positions& positions) const { return spoiltTriangles(positions).empty(); }

	/// The triangles that are slivers, and every flipped one with its neighbour.
	std::vector<int> spoiltTriangles(const Positions& positions) const;

	/// Changes a move such that it leaves a sound shape sound: a triangle that it would spoil moves as one
	/// piece, by the mean of what its corners would; what is held still stays so. \return whether that did
	bool mend(const Positions& from, Positions& move) const;

private:
	static constexpr int mendingRounds = 20;
	static constexpr double margin = 1.01; ///< for what rounding to the host's scalar may take away

	void moveAsOne(const Eigen::Vector3i& places, Positions& move) const;

	const PatchAssembly& assembly_;
	double greatestCotangent_ = 0;
	std::vector<std::pair<int, int>> hinges_; // pairs of neighbouring triangles that could flip
};

} // namespace developable::detail
