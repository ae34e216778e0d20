// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

int edgeCount(const FlatPatterns& patterns) {
	int count = 0;
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h)
		count += patterns.joinedHalfEdge[h] < h;
	return count;
}

TEST(PatternMeasures, APieceThatOverlapsItselfIsReported) {
	// A flat ribbon wound up as a helix: its pattern is a ring that goes round one and a half times.
	const auto helix = [](double u, double v) -> Eigen::Vector3d {
		const double angle = 3 * pi * u, radius = 1 + 0.3 * v;
		return {radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle};
	};
	const FlatPatterns patterns = flattened(grid(90, 4, helix));
	EXPECT_EQ(patterns.report.overlappingPieces, 1);
	EXPECT_EQ(patterns.report.flippedFaces, 0);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-2);
	EXPECT_EQ(patterns.report.notes.size(), 1u);
	const std::vector<std::array<int, 2>>& crossings = patterns.pieces.front().crossings;
	ASSERT_GE(crossings.size(), 4u); // both ends with both sides
	const auto middle = [&](int h) -> Eigen::Vector2d {
		return (patterns.positions.col(patterns.vertexAt(h)) +
				patterns.positions.col(patterns.vertexAt(nextCorner(h)))) /
			   2;
	};
	for (const auto& [one, other] : crossings)
		EXPECT_LT((middle(one) - middle(other)).norm(), 0.2); // an edge is a tenth long, the ring 2.6 wide
	EXPECT_TRUE(flattened(grid(9, 4, flatSheet)).pieces.front().crossings.empty());
}

TEST(PatternMeasures, MapsAddUpToTheReport) {
	const FlatPatterns patterns = flattened(together(jitteredGrid(12, 12, sphereCap(1)), ring(12, 8, tube)));
	EXPECT_EQ(patterns.edgeStrain.maxCoeff(), patterns.report.maxEdgeStrain);
	EXPECT_NEAR(patterns.elasticEnergy.sum(), patterns.report.elasticEnergy,
				1e-12 * patterns.report.elasticEnergy);
	double mean = 0;
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h) {
		if (patterns.joinedHalfEdge[h] >= h)
			continue;
		EXPECT_LE(patterns.joinedHalfEdge[h], h);
	}
	EXPECT_EQ(edgeCount(patterns), 12 * 11 * 2 + 11 * 11 + 12 * 8 + 12 * 7 * 2 + 7);
	for (const FlatPiece& piece : patterns.pieces)
		mean = std::max(mean, piece.meanEdgeStrain);
	EXPECT_GT(mean, patterns.report.meanEdgeStrain);
	const PatchAssembly assembly = assembled(together(jitteredGrid(12, 12, sphereCap(1)), ring(12, 8, tube)));
	EXPECT_EQ(largestAtPlaces(assembly, patterns, patterns.edgeStrain).maxCoeff(),
			  patterns.report.maxEdgeStrain);
}

/// Measures of a square of two triangles whose corners have these places in the pattern.
FlatPatterns measuredSquare(const Eigen::Matrix2Xd& flat, PatchAssembly& assembly) {
	assembly = assembled(grid(2, 2, flatSheet));
	FlattenOptions options;
	options.bounds = StrainBounds::isotropic(0.02, 0.02);
	FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions, options);
	for (int vertex = 0; vertex < 4; ++vertex)
		patterns.positions.col(vertex) = flat.col(patterns.placeOfVertex[vertex]);
	measurePatterns(assembly, assembly.originalPositions, patterns);
	return patterns;
}

TEST(PatternMeasures, WhatCollapsesCountsAsStretchedTenfold) {
	PatchAssembly assembly;
	const Eigen::Matrix2Xd square = assembled(grid(2, 2, flatSheet)).originalPositions.topRows(2);
	for (const double width : {0.5, 0.2, 0.05, 1e-9, 0.0}) {
		Eigen::Matrix2Xd thin = square;
		thin.row(0) *= width;
		const FlatPatterns patterns = measuredSquare(thin, assembly);
		const bool collapses = width < 0.1;
		EXPECT_EQ(patterns.report.collapsedFaces, collapses ? 2 : 0) << width;
		EXPECT_NEAR(patterns.report.maxStretch, collapses ? 9 : 1 / width - 1, 1e-9) << width;
		EXPECT_EQ(patterns.stretch.maxCoeff(), patterns.report.maxStretch);
		EXPECT_LE(patterns.report.beyondBounds, 9);
		EXPECT_GT(patterns.report.beyondBounds, patternTolerance);
		EXPECT_TRUE(std::isfinite(patterns.report.maxCompression));
		EXPECT_LE(patterns.report.maxCompression, 1);
		const auto& notes = patterns.report.notes;
		EXPECT_EQ(std::any_of(notes.begin(), notes.end(),
							  [](const std::string& note) {
								  return note.find("2 collapsed faces") != std::string::npos;
							  }),
				  collapses);
	}
}

} // namespace
} // namespace developable::test
