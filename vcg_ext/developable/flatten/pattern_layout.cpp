// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layout.cpp: the longest side of each piece, which goes upright, and the rows that pieces lie in.
#include "pattern_layout.h"

#include "grain_directions.h"
#include "seams.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

/// A part of a piece's boundary: its ends and its length.
struct BoundarySide {
	int start = -1, end = -1; ///< vertices
	double length = 0;
};

/// Where the model is longest: what is up in the model is up in the patterns too.
Eigen::Vector3d longestAxis(const Positions& positions) {
	int axis = 0;
	(positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).maxCoeff(&axis);
	return Eigen::Vector3d::Unit(axis);
}

/// Keeps the longest side of every piece.
class LongestSides {
public:
	explicit LongestSides(int pieceCount) : sides_(pieceCount) {}

	void offer(int piece, const BoundarySide& side) {
		// A side that comes back to where it began has no direction. Of sides that are alike the first
		// counts, so that neither strain nor moving the surface makes another one the longest.
		if (side.start != side.end && side.length > (1 + alike) * sides_[piece].length)
			sides_[piece] = side;
	}

	const std::vector<BoundarySide>& sides() const { return sides_; }

private:
	static constexpr double alike = 0.1; ///< share of the length

	std::vector<BoundarySide> sides_;
};

/// The two ends of a chain of half edges, the i-th of which meets the next at a vertex.
BoundarySide ends(const FlatPatterns& patterns, const std::vector<int>& chain) {
	const auto inner = [&](int h, int neighbour) {
		return patterns.vertexAt(h) == patterns.vertexAt(neighbour) ||
			   patterns.vertexAt(h) == patterns.vertexAt(nextCorner(neighbour));
	};
	const auto outerEnd = [&](int h, int neighbour) {
		return patterns.vertexAt(h != neighbour && inner(h, neighbour) ? nextCorner(h) : h);
	};
	BoundarySide side;
	side.start = outerEnd(chain.front(), chain[std::min<std::size_t>(1, chain.size() - 1)]);
	side.end = chain.size() == 1 ? patterns.vertexAt(nextCorner(chain.front()))
								 : outerEnd(chain.back(), chain[chain.size() - 2]);
	for (const int h : chain)
		side.length += patterns.length(h);
	return side;
}

/// Splits a closed boundary where it turns by more than 30° and offers its sides.
void offerSidesBetweenCorners(const FlatPatterns& patterns, const std::vector<int>& loop,
							  LongestSides& longest) {
	const int count = static_cast<int>(loop.size());
	const auto along = [&](int i) -> Eigen::Vector2d {
		return patterns.positions.col(loop[(i + 1) % count]) - patterns.positions.col(loop[i % count]);
	};
	const auto isCorner = [&](int i) {
		const Eigen::Vector2d before = along(i + count - 1), after = along(i);
		return before.dot(after) < std::cos(pi / 6) * before.norm() * after.norm();
	};
	int first = 0;
	while (first < count && !isCorner(first))
		++first;
	BoundarySide side;
	for (int i = first; i < first + count && first < count; ++i) {
		if (isCorner(i % count))
			side = {loop[i % count], -1, 0};
		side.length += along(i).norm();
		side.end = loop[(i + 1) % count];
		if (isCorner((i + 1) % count))
			longest.offer(patterns.pieceOfVertex[side.start], side);
	}
}

/// Which direction of a piece is to be upright: along its longest side, the way up that it has on the model.
Eigen::Vector2d uprightDirection(const FlatPatterns& patterns, const std::array<int, 2>& side,
								 const Positions& model, const Eigen::Vector3d& modelAxis,
								 const Eigen::Matrix2Xd& points) {
	if (side[0] < 0)
		return principalDirection(points);
	const Eigen::Vector2d chord = patterns.positions.col(side[1]) - patterns.positions.col(side[0]);
	const Eigen::Vector3d onModel =
		model.col(patterns.placeOfVertex[side[1]]) - model.col(patterns.placeOfVertex[side[0]]);
	return (onModel.dot(modelAxis) < 0 ? -1 : 1) * chord.normalized();
}

} // namespace

std::vector<std::array<int, 2>> longestSides(const PatchAssembly& assembly, const FlatPatterns& patterns,
											 const std::vector<std::vector<int>>& outerLoops) {
	const int pieceCount = static_cast<int>(outerLoops.size());
	LongestSides bySeams(pieceCount), byCorners(pieceCount);
	for (const Seam& seam : findSeams(assembly, patterns))
		for (const int side : {0, 1})
			bySeams.offer(seam.piece[side], ends(patterns, seam.halfEdges[side]));
	std::vector<std::array<int, 2>> result(pieceCount, {-1, -1});
	for (int piece = 0; piece < pieceCount; ++piece) {
		offerSidesBetweenCorners(patterns, outerLoops[piece], byCorners);
		const BoundarySide& seam = bySeams.sides()[piece];
		const BoundarySide& side = seam.length > 0 ? seam : byCorners.sides()[piece];
		if (!(side.length > 0))
			continue;
		const double chord = (patterns.positions.col(side.end) - patterns.positions.col(side.start)).norm();
		if (chord > 1e-6 * side.length)
			result[piece] = {side.start, side.end};
	}
	return result;
}

void standUpright(const Positions& model, FlatPatterns& patterns,
				  const std::vector<std::array<int, 2>>& longestSides, const std::vector<int>& firstVertex) {
	const Eigen::Vector3d modelAxis = longestAxis(model);
	for (std::size_t piece = 0; piece < longestSides.size(); ++piece) {
		auto points =
			patterns.positions.middleCols(firstVertex[piece], firstVertex[piece + 1] - firstVertex[piece]);
		const Eigen::Vector2d up = uprightDirection(patterns, longestSides[piece], model, modelAxis, points);
		Eigen::Matrix2d rotation;
		rotation << up[1], -up[0], up[0], up[1];
		points = (rotation * points).eval();
	}
}

void laySideBySide(FlatPatterns& patterns, const std::vector<int>& firstVertex, double gap) {
	const int pieceCount = static_cast<int>(firstVertex.size()) - 1;
	Eigen::Matrix2Xd least(2, pieceCount), size(2, pieceCount);
	for (int piece = 0; piece < pieceCount; ++piece) {
		const auto points =
			patterns.positions.middleCols(firstVertex[piece], firstVertex[piece + 1] - firstVertex[piece]);
		least.col(piece) = points.rowwise().minCoeff();
		size.col(piece) = points.rowwise().maxCoeff() - least.col(piece);
	}
	if (gap < 0)
		gap = 0.02 * size.colwise().norm().maxCoeff();
	// As wide as a square that would hold them all, with room to spare; one row when there are few.
	const Eigen::Array2Xd taken = size.array() + gap;
	const double width = std::max(1.5 * std::sqrt((taken.row(0) * taken.row(1)).sum()),
								  taken.row(0).leftCols(std::min(pieceCount, 4)).sum());
	Eigen::Vector2d corner = Eigen::Vector2d::Zero();
	double rowHeight = 0;
	for (int piece = 0; piece < pieceCount; ++piece) {
		if (corner[0] > 0 && corner[0] + size(0, piece) > width) {
			corner = Eigen::Vector2d(0, corner[1] + rowHeight + gap);
			rowHeight = 0;
		}
		patterns.positions.middleCols(firstVertex[piece], firstVertex[piece + 1] - firstVertex[piece])
			.colwise() += corner - least.col(piece);
		corner[0] += size(0, piece) + gap;
		rowHeight = std::max(rowHeight, size(1, piece));
	}
}

} // namespace developable::detail
