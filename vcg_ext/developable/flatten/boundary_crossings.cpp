// SPDX-License-Identifier: GPL-3.0-or-later
// boundary_crossings.cpp: a sweep over the boundary segments of a layout.
#include "boundary_crossings.h"

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

namespace {

/// True when two segments cross, deeper than the rounding of their coordinates.
/// \param tolerance  area below which three points count as on one line
bool cross(const Eigen::Matrix2Xd& positions, const BoundarySegment& a, const BoundarySegment& b,
		   double tolerance) {
	const auto side = [&](int from, int to, int point) {
		const Eigen::Vector2d u = positions.col(to) - positions.col(from);
		const Eigen::Vector2d v = positions.col(point) - positions.col(from);
		const double area = u[0] * v[1] - u[1] * v[0];
		return (area > tolerance) - (area < -tolerance);
	};
	return side(a.start, a.end, b.start) * side(a.start, a.end, b.end) < 0 &&
		   side(b.start, b.end, a.start) * side(b.start, b.end, a.end) < 0;
}

} // namespace

std::vector<PieceCrossing> crossingPieces(const Eigen::Matrix2Xd& positions,
										  std::vector<BoundarySegment> segments, int pieceCount) {
	std::vector<PieceCrossing> crossing(pieceCount);
	if (segments.empty())
		return crossing;
	const double size = boxDiagonal(positions);
	const double tolerance = 1e-14 * size * size;
	const auto left = [&](const BoundarySegment& s) {
		return std::min(positions(0, s.start), positions(0, s.end));
	};
	const auto right = [&](const BoundarySegment& s) {
		return std::max(positions(0, s.start), positions(0, s.end));
	};
	std::sort(segments.begin(), segments.end(), [&](const BoundarySegment& a, const BoundarySegment& b) {
		return std::make_pair(left(a), a.start) < std::make_pair(left(b), b.start);
	});
	std::vector<BoundarySegment> active;
	for (const BoundarySegment& segment : segments) {
		active.erase(std::remove_if(active.begin(), active.end(),
									[&](const BoundarySegment& s) { return right(s) < left(segment); }),
					 active.end());
		for (const BoundarySegment& other : active) {
			PieceCrossing &one = crossing[segment.piece], &two = crossing[other.piece];
			const bool same = segment.piece == other.piece;
			if ((!same && one.crosses && two.crosses) || !cross(positions, segment, other, tolerance))
				continue;
			one.crosses = two.crosses = true;
			if (same)
				one.itself.push_back({segment.halfEdge, other.halfEdge});
		}
		active.push_back(segment);
	}
	return crossing;
}

} // namespace developable::detail
