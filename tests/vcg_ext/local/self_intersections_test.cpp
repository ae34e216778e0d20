// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local/local_method.h"

#include "developable/vcg_mesh/vcg_mesh.h"
#include "support/local_method_cases.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

PlacedTriangle placed(const Eigen::Vector3i& places, const Positions& positions) {
	return {places, positions(Eigen::all, places)};
}

/// How many pairs of triangles cut each other.
int countIntersections(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<PlacedTriangle> triangles;
	for (const auto& places : assembly.trianglePlaces.colwise())
		triangles.push_back(placed(places, positions));
	int count = 0;
	for (std::size_t a = 0; a < triangles.size(); ++a)
		for (std::size_t b = 0; b < a; ++b)
			count += intersect(triangles[a], triangles[b]);
	return count;
}

/// A crumpled sheet just above a flat one.
TriangleMesh crumpledAboveFlat(unsigned seed) {
	std::mt19937 random(seed);
	const auto crumpled = [&](double u, double v) -> Eigen::Vector3d {
		return {u, v, 0.005 + 0.05 * random() / std::mt19937::max()};
	};
	return together(grid(13, 13, crumpled), grid(12, 12, flatSheet));
}

TEST(LocalMethod, AvoidsSelfIntersectionsWhereThePapersMovesMakeThem) {
	const PatchAssembly assembly = assembled(crumpledAboveFlat(5));
	ASSERT_EQ(countIntersections(assembly, assembly.originalPositions), 0);
	LocalMethodOptions options;
	options.maxDisplacement = 0.2;
	Positions through = assembly.originalPositions, clear = through;
	localMethod(assembly, through, options);
	EXPECT_GT(countIntersections(assembly, through), 0);
	options.avoidSelfIntersections = true;
	const LocalMethodReport report = localMethod(assembly, clear, options);
	EXPECT_EQ(countIntersections(assembly, clear), 0);
	EXPECT_GT(report.refusedMoves, 0);
	EXPECT_LT(measured(assembly, clear).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
}

TEST(LocalMethod, AvoidsSelfIntersectionsThatRoundingWouldMake) {
	LocalMethodOptions options;
	options.maxDisplacement = 0.2;
	options.avoidSelfIntersections = true;
	int unaware = 0, aware = 0;
	for (unsigned seed = 1; seed <= 8; ++seed) {
		TriangleMesh mesh = crumpledAboveFlat(seed);
		mesh.positions = rounded<float>((mesh.positions.array() + 1000).matrix()); // rounding counts far out
		const PatchAssembly assembly = assembled(mesh);
		ASSERT_EQ(countIntersections(assembly, assembly.originalPositions), 0);
		for (const bool roundedToFloat : {false, true}) {
			options.roundedToFloat = roundedToFloat;
			Positions positions = assembly.originalPositions;
			localMethod(assembly, positions, options);
			(roundedToFloat ? aware : unaware) += countIntersections(assembly, rounded<float>(positions));
		}
	}
	EXPECT_GT(unaware, 0);
	EXPECT_EQ(aware, 0);
}

} // namespace
} // namespace developable::test
