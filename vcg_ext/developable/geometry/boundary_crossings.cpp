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

/// How often a closed border goes round a point, counter-clockwise.
int windingNumber(const Eigen::Matrix2Xd& border, const Eigen::Vector2d& point) {
	int turns = 0;
	for (Eigen::Index i = 0; i < border.cols(); ++i) {
		const Eigen::Vector2d a = border.col(i) - point, b = border.col((i + 1) % border.cols()) - point;
		if ((a[1] <= 0) == (b[1] <= 0))
			continue;
		const bool isToTheLeft = a[0] * b[1] - a[1] * b[0] > 0;
		if (isToTheLeft == (a[1] <= 0))
			turns += a[1] <= 0 ? 1 : -1;
	}
	return turns;
}

} // namespace

double longestCoveredStretch(const Eigen::Matrix2Xd& border) {
	constexpr double beside = 1e-3; // of an edge
	const Eigen::Index count = border.cols();
	double longest = 0, stretch = 0;
	for (Eigen::Index i = 0; i < 2 * count; ++i) { // twice round: a stretch may begin anywhere
		const Eigen::Vector2d from = border.col(i % count), along = border.col((i + 1) % count) - from;
		const Eigen::Vector2d outside = from + along / 2 + beside * Eigen::Vector2d(along[1], -along[0]);
		stretch = windingNumber(border, outside) > 0 ? stretch + along.norm() : 0;
		longest = std::max(longest, stretch);
	}
	return longest;
}

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
