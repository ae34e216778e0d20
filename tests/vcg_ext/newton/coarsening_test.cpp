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
