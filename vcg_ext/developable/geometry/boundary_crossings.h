// SPDX-License-Identifier: GPL-3.0-or-later
// boundary_crossings.h: which pieces of a layout cross themselves or another, by their boundary segments.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace developable::detail {

struct BoundarySegment {
	int start, end; ///< vertices
	int piece;
	int halfEdge;
};

struct PieceCrossing {
	bool crosses = false;                   ///< itself or another piece
	std::vector<std::array<int, 2>> itself; ///< pairs of half edges where it crosses itself
};

/// Per piece, where its boundary crosses itself, or whether it does another's. A disk without flips whose
/// boundary does not cross itself covers nothing twice. Segments are swept from left to right.
/// \param positions  2 x vertices
std::vector<PieceCrossing> crossingPieces(const Eigen::Matrix2Xd& positions,
										  std::vector<BoundarySegment> segments, int pieceCount);

/// Of a closed border, whose piece is to its left, the longest stretch that lies upon the piece itself,
/// length. Where it is short, the piece covers itself by a sliver.
/// \param border  2 x points, one after the other
double longestCoveredStretch(const Eigen::Matrix2Xd& border);

} // namespace developable::detail
