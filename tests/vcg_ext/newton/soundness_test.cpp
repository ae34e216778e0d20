// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/soundness.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

TEST(Soundness, SeesFlipsAndSlivers) {
	const PatchAssembly assembly = assembled(grid(5, 5, flatSheet));
	const detail::Soundness soundness(assembly, {});
	EXPECT_TRUE(soundness.holds(assembly.originalPositions));
	Positions sliver = assembly.originalPositions;
	sliver(0, 12) = 0.999 * sliver(0, 13) + 0.001 * sliver(0, 12); // the middle almost on its right neighbour
	EXPECT_FALSE(soundness.holds(sliver));
	Positions flipped = assembly.originalPositions;
	flipped(0, 12) += 0.4; // and beyond it
	EXPECT_FALSE(soundness.holds(flipped));
	EXPECT_EQ(soundness.spoiltTriangles(assembly.originalPositions), std::vector<int>());
	Positions move = flipped - assembly.originalPositions;
	EXPECT_TRUE(soundness.spare(assembly.originalPositions, move));
	EXPECT_TRUE(soundness.holds(assembly.originalPositions + move));
	EXPECT_GT(move.norm(), 0.1);
	PatchAssembly held = assembly;
	held.placeFixed.assign(held.placeCount(), 1);
	held.placeFixed[12] = 0;
	move = flipped - assembly.originalPositions;
	EXPECT_TRUE(detail::Soundness(held, {}).spare(assembly.originalPositions, move));
	EXPECT_EQ(move.col(13), Eigen::Vector3d::Zero());
	Positions missing = assembly.originalPositions;
	missing(1, 3) = std::nan("");
	EXPECT_FALSE(soundness.holds(missing));
}

TEST(Soundness, SparesWhatIsSpoiltAfterEachRoundAsSeenAnew) {
	const PatchAssembly assembly = assembled(jitteredGrid(20, 20, saddle));
	NewtonTuning once;
	once.sparingRounds = 1;
	const detail::Soundness soundness(assembly, {}), roundByRound(assembly, once);
	int rounds = 0;
	for (const double size : {0.01, 0.03, 0.05, 0.2}) {
		Positions move =
			size * Positions(Positions::NullaryExpr(3, assembly.placeCount(), [&](auto i, auto p) {
				return std::sin(double(7 * i + 1) * double(p * p % 101));
			}));
		Positions expected = move;
		bool spared = false;
		for (int round = 0; round < NewtonTuning().sparingRounds && !spared; ++round, ++rounds)
			spared = roundByRound.spare(assembly.originalPositions, expected);
		EXPECT_EQ(soundness.spare(assembly.originalPositions, move), spared) << size;
		EXPECT_EQ(move, expected) << size;
	}
	EXPECT_GT(rounds, 10); // the cases are what they claim to be
}

/// A strip of triangles that is twisted once and closed: it has one side.
TriangleMesh moebiusStrip(int columns) {
	TriangleMesh mesh = grid(columns, 4, [](double u, double v) -> Eigen::Vector3d {
		const double turn = 2 * pi * u, across = 0.4 * (v - 0.5);
		return {(1 + across * std::cos(turn / 2)) * std::cos(turn),
				(1 + across * std::cos(turn / 2)) * std::sin(turn), across * std::sin(turn / 2)};
	});
	// The last column is the first one upside down.
	for (int& vertex : mesh.triangles.reshaped())
		if (vertex % columns == columns - 1)
			vertex = (3 - vertex / columns) * columns;
	return makeMesh(mesh.positions, mesh.triangles);
}

TEST(Soundness, SeesFlipsAllRoundAPatchWithOneSide) {
	constexpr int columns = 24;
	const PatchAssembly assembly = assembled(moebiusStrip(columns));
	ASSERT_FALSE(assembly.patches[0].orientable);
	const detail::Soundness soundness(assembly, {});
	EXPECT_TRUE(soundness.holds(assembly.originalPositions));
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		if (!assembly.copyInterior[copy])
			continue;
		// Along the strip beyond its neighbour: the triangles on that side turn over.
		Positions flipped = assembly.originalPositions;
		const int place = assembly.placeOfCopy[copy];
		const Eigen::Vector3d at = flipped.col(place);
		flipped.col(place) += 0.5 * Eigen::Vector3d(-at[1], at[0], 0).normalized();
		EXPECT_FALSE(soundness.holds(flipped)) << place;
	}
}

} // namespace
} // namespace developable::test
