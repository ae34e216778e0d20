// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/coarsening.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

int eulerCharacteristic(const PatchAssembly& assembly) {
	int sum = 0;
	for (const Patch& patch : assembly.patches)
		sum += patch.eulerCharacteristic();
	return sum;
}

TEST(Coarsening, KeepsTopologySeamsAndPositions) {
	for (const PatchAssembly& fine : {sewnPatches(31), assembled(jitteredGrid(41, 41, steepBump)),
									  assembled(withTwoHoles(41, bumpedCylinder))}) {
		const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(fine.placeCount() / 4);
		EXPECT_EQ(coarse.assembly.placeCount(), fine.placeCount() / 4);
		EXPECT_EQ(coarse.assembly.patchCount(), fine.patchCount());
		EXPECT_EQ(eulerCharacteristic(coarse.assembly), eulerCharacteristic(fine));
		EXPECT_EQ(coarse.assembly.originalPositions,
				  fine.originalPositions(Eigen::all, coarse.wholePlace).eval());
		for (int place = 0; place < coarse.assembly.placeCount(); ++place)
			EXPECT_EQ(coarse.assembly.placeAssembling[place], fine.placeAssembling[coarse.wholePlace[place]]);
		for (const auto& places : coarse.assembly.trianglePlaces.colwise())
			EXPECT_TRUE(places[0] != places[1] && places[1] != places[2] && places[2] != places[0]);
		EXPECT_GT(smallestAngle(coarse.assembly, coarse.assembly.originalPositions), 7 * pi / 180);
		EXPECT_EQ(flippedTriangles(coarse.assembly, coarse.assembly.originalPositions), 0);
	}
}

/// The share that the smallest inner place has of the area, beside the mean of all inner ones.
double leastShare(const PatchAssembly& assembly) {
	const Eigen::VectorXd areas = copyAreas(assembly, assembly.originalPositions);
	double least = areas.maxCoeff(), sum = 0;
	int count = 0;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.copyInterior[copy]) {
			least = std::min(least, areas[copy]);
			sum += areas[copy];
			++count;
		}
	return least * count / sum;
}

/// The square of complex numbers makes triangles up to fifty times as large as others, and none thin.
TEST(Coarsening, TakesOutWhereTrianglesAreSmall) {
	TriangleMesh mesh = jitteredGrid(41, 41, flatSheet);
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
		const double x = 0.15 + mesh.positions(0, vertex), y = 0.15 + mesh.positions(1, vertex);
		mesh.positions.col(vertex) = Eigen::Vector3d(x * x - y * y, 2 * x * y, 0);
	}
	const PatchAssembly fine = assembled(mesh);
	const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(fine.placeCount() / 4);
	EXPECT_LT(leastShare(fine), 0.1);
	EXPECT_GT(leastShare(coarse.assembly), 0.25);
}

/// A border in zigzag turns sharply everywhere, but by less than a coarse edge.
TEST(Coarsening, TakesOutJagsOfABorder) {
	TriangleMesh mesh = jitteredGrid(41, 41, flatSheet);
	for (int vertex = 1; vertex < 41; vertex += 2)
		mesh.positions(1, vertex) -= 0.5 / 40;
	const PatchAssembly fine = assembled(mesh);
	const auto left = [&](const NewtonTuning& with) {
		const PartialAssembly coarse = detail::Coarsening(fine, with).coarsen(100);
		return std::count_if(coarse.wholePlace.begin(), coarse.wholePlace.end(),
							 [](int place) { return place < 41; });
	};
	NewtonTuning tuning;
	tuning.coarseShortening = 0.001;
	EXPECT_LT(left({}), 20);
	EXPECT_GT(left(tuning), 30);
}

TEST(Coarsening, KeepsCornersAndAllOfTheAreaOfASheet) {
	const PatchAssembly sheet = assembled(jitteredGrid(41, 41, flatSheet));
	const PartialAssembly coarse = detail::Coarsening(sheet, {}).coarsen(100);
	EXPECT_NEAR(copyAreas(coarse.assembly, coarse.assembly.originalPositions).sum(), 1, 1e-12);
}

TEST(Coarsening, TakesHeldPlacesOutOnlyFromAmongHeldOnes) {
	TriangleMesh mesh = jitteredGrid(41, 41, saddle);
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		mesh.vertexSelected[vertex] = vertex % 41 < 20;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly fine = assembled(mesh, options);
	const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(500);
	std::vector<char> kept(fine.placeCount(), 0);
	for (int place = 0; place < coarse.assembly.placeCount(); ++place) {
		kept[coarse.wholePlace[place]] = 1;
		EXPECT_EQ(coarse.assembly.placeFixed[place], fine.placeFixed[coarse.wholePlace[place]]);
	}
	int rimKept = 0, innerKept = 0;
	for (int row = 0; row < 41; ++row) {
		rimKept += kept[41 * row + 19]; // has neighbours that are free
		innerKept += kept[41 * row + 10];
	}
	EXPECT_GT(rimKept, 35);
	EXPECT_LT(innerKept, 20);
}

} // namespace
} // namespace developable::test
