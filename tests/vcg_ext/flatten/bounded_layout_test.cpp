// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/flatten.h"

#include "flat_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

FlatPatterns within(const TriangleMesh& mesh, const StrainBounds& bounds,
					const Grain& grain = Grain::LongestSeam) {
	FlattenOptions options;
	options.bounds = bounds;
	options.grain = grain;
	return flattened(mesh, options);
}

TEST(BoundedLayout, KeepsBoundsOfEitherSignAndCostsEnergy) {
	const TriangleMesh mesh = jitteredGrid(15, 15, bump(0.12, 12));
	const FlatPatterns free = flattened(mesh);
	const double s = free.report.maxStretch, c = free.report.maxCompression;
	ASSERT_GT(std::min(s, c), 0.01);
	for (const auto& [stretch, compression] : {std::pair(0.8 * s, c), std::pair(s, 0.85 * c)}) {
		const FlatPatterns bounded = within(mesh, StrainBounds::isotropic(stretch, compression));
		EXPECT_LT(bounded.report.maxStretch, stretch + 1e-4);
		EXPECT_LT(bounded.report.maxCompression, compression + 1e-4);
		EXPECT_EQ(bounded.report.flippedFaces, 0);
		EXPECT_GT(bounded.report.elasticEnergy, 0.99 * free.report.elasticEnergy);
		EXPECT_TRUE(bounded.report.notes.empty());
	}
}

TEST(BoundedLayout, AmongThoseWithinTheBoundsItIsTheLeastSumOfSquares) {
	const TriangleMesh mesh = jitteredGrid(12, 12, bump(0.12, 12));
	const double wide = within(mesh, StrainBounds::isotropic(1, 0.9)).report.elasticEnergy;
	double before = wide;
	for (const double share : {0.9, 0.8, 0.7}) {
		const FlatPatterns free = flattened(mesh);
		const double energy =
			within(mesh, StrainBounds::isotropic(share * free.report.maxStretch, 0.9)).report.elasticEnergy;
		EXPECT_GT(energy, before * (1 - 1e-6));
		before = energy;
	}
	// With bounds that touch nothing it is the minimum itself.
	EXPECT_LE(wide, flattened(mesh).report.elasticEnergy * (1 + 1e-9));
}

TEST(BoundedLayout, SaysWhereNoPatternIsWithinTheBounds) {
	const FlatPatterns patterns =
		within(jitteredGrid(15, 15, bump(0.3, 12)), StrainBounds::isotropic(1e-3, 1e-3));
	EXPECT_GT(patterns.report.beyondBounds, 1e-3);
	EXPECT_EQ(patterns.report.flippedFaces, 0);
	ASSERT_EQ(patterns.report.notes.size(), 1u);
	EXPECT_NE(patterns.report.notes[0].find("beyond it by"), std::string::npos);
	ASSERT_GE(patterns.pieces[0].worstTriangle, 0);
}

TEST(BoundedLayout, GrainAlongAnAxisTurnsWithIt) {
	// A sheet stretched along x, that is, the pattern would be shorter there: only the direction that
	// bears it has a pattern of the sheet's own sides shortened.
	const TriangleMesh mesh = jitteredGrid(13, 13, bump(0.1, 12));
	const FlatPatterns free = flattened(mesh);
	StrainBounds bounds = StrainBounds::isotropic(1, 0.9);
	bounds.directed = true;
	bounds.warp = {0.3 * free.report.maxStretch, 0.9};
	double energies[2];
	for (const Grain::Choice grain : {Grain::XAxis, Grain::YAxis}) {
		const FlatPatterns patterns = within(mesh, bounds, grain);
		EXPECT_LT(patterns.report.beyondBounds, 1e-4);
		const Eigen::Matrix3Xi& triangles = patterns.triangles;
		const PatchAssembly assembly = assembled(mesh);
		// The stretch along the axis, measured anew: of the plane direction that the axis has on the mean.
		const StrainedTriangles strained = strainedTriangles(assembly, assembly.originalPositions, patterns);
		const double angle = strained.grain[0];
		double greatest = 0;
		for (int t = 0; t < triangles.cols(); ++t) {
			const TriangleStrain strain(assembly.originalPositions(Eigen::all, strained.shaped.col(t)),
										patterns.positions(Eigen::all, strained.flat.col(t)));
			greatest = std::max(greatest,
								(strain.map * Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm() - 1);
		}
		EXPECT_LT(greatest, bounds.warp.stretch + 1e-4);
		EXPECT_GT(patterns.report.maxStretch, bounds.warp.stretch);
		energies[grain == Grain::YAxis] = patterns.report.elasticEnergy;
	}
	EXPECT_NEAR(energies[0] / energies[1], 1, 0.2); // a bump is much the same both ways
}

TEST(BoundedLayout, WithoutBoundsNothingIsDifferent) {
	const TriangleMesh mesh = jitteredGrid(12, 12, bump(0.1, 12));
	EXPECT_EQ(flattened(mesh).positions, within(mesh, StrainBounds()).positions);
}

TEST(BoundedLayout, BadBoundsAreRefused) {
	EXPECT_THROW(within(grid(4, 4, flatSheet), StrainBounds::isotropic(-0.1, 0)), InvalidParameter);
	EXPECT_THROW(within(grid(4, 4, flatSheet), StrainBounds::isotropic(0, 1)), InvalidParameter);
}

} // namespace
} // namespace developable::test
