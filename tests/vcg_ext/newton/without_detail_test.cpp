// SPDX-License-Identifier: GPL-3.0-or-later
// Noise goes where it is little beside how far places may move, and nothing else does.
#include "developable/newton/without_detail.h"

#include "support/newton_checks.h"

#include <Eigen/Geometry>

namespace developable::test {
namespace {

constexpr double noise = 0.1; // of an edge

double farEnough(const PatchAssembly& assembly) {
	return 0.02 * boxDiagonal(assembly.originalPositions);
}

double curvatureOf(const PatchAssembly& assembly) {
	return angleDefects(assembly, assembly.originalPositions).cwiseAbs().sum();
}

double meanDistance(const PatchAssembly& from, const TriangleMesh& to) {
	return distancesToSurface(from.originalPositions, to.positions, to.triangles).mean();
}

TEST(WithoutDetail, IsNearerToWhatTheNoiseWasAddedTo) {
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(wave), Surface(largeSaddle)}) {
		const TriangleMesh clean = jitteredGrid(31, 31, surface);
		const PatchAssembly original = assembled(noisy(clean, noise));
		const std::optional<PatchAssembly> smoothed = withoutDetail(original, farEnough(original));
		ASSERT_TRUE(smoothed);
		EXPECT_LT(meanDistance(*smoothed, clean), 0.6 * meanDistance(original, clean));
		EXPECT_LT(curvatureOf(*smoothed), 0.5 * curvatureOf(original));
		EXPECT_EQ(smoothed->trianglePlaces, original.trianglePlaces);
	}
}

TEST(WithoutDetail, IsNothingOfASmoothSurface) {
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(largeSaddle), sphereCap(1)}) {
		const PatchAssembly original = assembled(jitteredGrid(31, 31, surface));
		EXPECT_FALSE(withoutDetail(original, farEnough(original)));
	}
	const PatchAssembly flat = assembled(jitteredGrid(31, 31, flatSheet));
	EXPECT_FALSE(withoutDetail(flat, farEnough(flat)));
}

TEST(WithoutDetail, IsNothingWherePlacesMayHardlyMove) {
	const PatchAssembly original = assembled(noisy(jitteredGrid(31, 31, wave), noise));
	NewtonTuning once;
	once.detailSteps = 1;
	const std::optional<PatchAssembly> smoothed = withoutDetail(original, farEnough(original), once);
	ASSERT_TRUE(smoothed);
	const Positions move = smoothed->originalPositions - original.originalPositions;
	const double least = move.norm() / std::sqrt(double(original.placeCount())) / once.detailMove;
	EXPECT_TRUE(withoutDetail(original, 1.001 * least, once));
	EXPECT_FALSE(withoutDetail(original, 0.999 * least, once));
}

/// More noise takes more steps, of which none leaves so much as the one before.
TEST(WithoutDetail, GoesOnWhereThereIsMore) {
	const PatchAssembly original = assembled(noisy(jitteredGrid(41, 41, wave), 2 * noise));
	NewtonTuning once;
	once.detailSteps = 1;
	const std::optional<PatchAssembly> less = withoutDetail(original, farEnough(original), once);
	const std::optional<PatchAssembly> all = withoutDetail(original, farEnough(original));
	ASSERT_TRUE(less && all);
	EXPECT_LT(curvatureOf(*all), 0.65 * curvatureOf(*less));
	EXPECT_LT(roomOfDetail(original, *less), roomOfDetail(original, *all));
	EXPECT_LE(roomOfDetail(original, *all), 2 * once.detailMove * farEnough(original));
}

TEST(WithoutDetail, IsTheSameWhereverASurfaceIsAndHoweverLarge) {
	TriangleMesh mesh = noisy(jitteredGrid(31, 31, bumpedCylinder), noise);
	const PatchAssembly here = assembled(mesh);
	const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
	mesh.positions = turn * moved(mesh.positions, 40, {3, 1, -5});
	const PatchAssembly there = assembled(mesh);
	const std::optional<PatchAssembly> smoothedHere = withoutDetail(here, farEnough(here));
	const std::optional<PatchAssembly> smoothedThere = withoutDetail(there, 40 * farEnough(here));
	ASSERT_TRUE(smoothedHere && smoothedThere);
	const Positions expected = turn * moved(smoothedHere->originalPositions, 40, {3, 1, -5});
	EXPECT_LT((smoothedThere->originalPositions - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(WithoutDetail, KeepsHeldPlaces) {
	PatchAssembly original = assembled(noisy(jitteredGrid(31, 31, wave), noise));
	for (int place = 0; place < 40; ++place)
		original.placeFixed[place] = 1;
	const std::optional<PatchAssembly> smoothed = withoutDetail(original, farEnough(original));
	ASSERT_TRUE(smoothed);
	for (int place = 0; place < original.placeCount(); ++place)
		EXPECT_EQ(smoothed->originalPositions.col(place) == original.originalPositions.col(place),
				  place < 40);
}

/// Knobs of few triangles each bend much, too, but what goes of them is alike at neighbours.
TEST(WithoutDetail, LeavesFeaturesOfFewTriangles) {
	const auto knobs = [](double u, double v) {
		return Eigen::Vector3d(u, v, 0.02 * std::sin(10 * pi * u) * std::sin(10 * pi * v));
	};
	const PatchAssembly original = assembled(jitteredGrid(41, 41, knobs));
	EXPECT_FALSE(withoutDetail(original, farEnough(original)));
	NewtonTuning alike;
	alike.detailLikeness = 0.5;
	EXPECT_TRUE(withoutDetail(original, farEnough(original), alike));
}

} // namespace
} // namespace developable::test
