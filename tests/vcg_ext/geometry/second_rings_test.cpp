// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/second_rings.h"

#include "developable/geometry/geometry.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <set>

namespace developable::test {
namespace {

/// A cap of the unit sphere: a hub with many spokes, and rings of as many vertices round it.
TriangleMesh hubOfSpokes(int spokes, int rings, bool closed = true) {
	Positions positions(3, 1 + spokes * rings);
	positions.col(0) << 0, 0, 1;
	for (int ring = 0; ring < rings; ++ring)
		for (int spoke = 0; spoke < spokes; ++spoke) {
			const double turn = 2 * pi * spoke / spokes, tilt = 0.1 * (ring + 1);
			positions.col(1 + ring * spokes + spoke) << std::sin(tilt) * std::cos(turn),
				std::sin(tilt) * std::sin(turn), std::cos(tilt);
		}
	std::vector<Eigen::Vector3i> triangles;
	for (int spoke = 0; spoke < spokes - !closed; ++spoke) {
		const int next = (spoke + 1) % spokes;
		triangles.emplace_back(0, 1 + spoke, 1 + next);
		for (int ring = 0; ring + 1 < rings; ++ring) {
			const int a = 1 + ring * spokes + spoke, b = 1 + ring * spokes + next;
			triangles.emplace_back(a, a + spokes, b + spokes);
			triangles.emplace_back(a, b + spokes, b);
		}
	}
	Eigen::Matrix3Xi columns(3, triangles.size());
	for (std::size_t t = 0; t < triangles.size(); ++t)
		columns.col(Eigen::Index(t)) = triangles[t];
	return makeMesh(positions, columns);
}

std::size_t sizeOfAllRings(const PatchAssembly& assembly) {
	const detail::SecondRings rings(assembly);
	std::vector<int> ring;
	std::size_t size = 0;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		rings.collect(copy, ring);
		size += ring.size();
	}
	return size;
}

TEST(SecondRings, HoldTheNeighboursOfNeighbours) {
	TriangleMesh mesh = jitteredGrid(8, 7, saddle);
	for (int t = 0; t < mesh.triangleCount(); t += 3) // sides do not matter
		mesh.triangles.col(t).reverseInPlace();
	const PatchAssembly assembly = assembled(mesh);
	std::vector<std::set<int>> neighbours(assembly.copyCount());
	for (const auto& triangle : assembly.triangleCopies.colwise())
		for (const int copy : triangle)
			neighbours[copy].insert(triangle.begin(), triangle.end());
	const detail::SecondRings rings(assembly);
	std::vector<int> ring;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		std::set<int> expected;
		for (const int neighbour : neighbours[copy])
			expected.insert(neighbours[neighbour].begin(), neighbours[neighbour].end());
		expected.erase(copy);
		rings.collect(copy, ring);
		EXPECT_EQ(ring, std::vector<int>(expected.begin(), expected.end()));
	}
}

TEST(SecondRings, GrowWithTheSpokesOfAHubAndNoFaster) {
	for (const bool closed : {true, false}) {
		const auto few = sizeOfAllRings(assembled(hubOfSpokes(500, 1, closed)));
		const auto many = sizeOfAllRings(assembled(hubOfSpokes(4000, 1, closed)));
		EXPECT_LT(many, 8.5 * few);
		EXPECT_GT(many, 7 * few);
	}
}

TEST(SecondRings, CurvaturesAtAHubOfManySpokesAreTheSpheres) {
	for (const int spokes : {12, 64, 300}) {
		const TriangleMesh mesh = hubOfSpokes(spokes, 4);
		const PatchAssembly assembly = assembled(mesh);
		const PrincipalCurvatures curvatures = principalCurvatures(assembly, mesh.positions);
		for (int copy = 0; copy < assembly.copyCount(); ++copy) {
			if (assembly.placeOfCopy[copy] > spokes) // the hub and its first ring
				continue;
			EXPECT_NEAR(curvatures.least[copy], 1, 0.03) << spokes;
			EXPECT_NEAR(curvatures.greatest[copy], 1, 0.03) << spokes;
		}
	}
}

TEST(SecondRings, CurvaturesDoNotDependOnNumbers) {
	const TriangleMesh mesh = hubOfSpokes(200, 3);
	TriangleMesh turned = mesh; // faces from the last to the first, corners from the second on
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const Eigen::Vector3i triangle = mesh.triangles.col(mesh.triangleCount() - 1 - t);
		turned.triangles.col(t) << triangle[1], triangle[2], triangle[0];
	}
	const PatchAssembly one = assembled(mesh), other = assembled(turned);
	const PrincipalCurvatures a = principalCurvatures(one, mesh.positions),
							  b = principalCurvatures(other, mesh.positions);
	EXPECT_LT((largestCopies(one, a.greatest) - largestCopies(other, b.greatest)).cwiseAbs().maxCoeff(),
			  1e-9);
	EXPECT_LT((largestCopies(one, a.least) - largestCopies(other, b.least)).cwiseAbs().maxCoeff(), 1e-9);
}

} // namespace
} // namespace developable::test
