// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/assemble_patches.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

#include <limits>

namespace developable::test {
namespace {

TEST(AssemblePatches, WeldDistanceOutOfRangeIsRefused) {
	const TriangleMesh mesh = pyramid(origin, x, y, 0.3);
	for (const double distance : {-1e-9, std::nan(""), std::numeric_limits<double>::infinity()})
		EXPECT_NE(refusal<InvalidParameter>(mesh, welding(distance)).find("weld distance"),
				  std::string::npos);
}

TEST(AssemblePatches, OnlySelectedWithNothingSelectedIsRefused) {
	EXPECT_NE(refusal<EmptyMesh>(pyramid(origin, x, y, 0.3), selectedOnly()).find("No face is selected"),
			  std::string::npos);
}

TEST(AssemblePatches, CoordinateThatIsNoNumberIsCounted) {
	TriangleMesh mesh = grid(4, 4, flatSheet);
	mesh.positions(1, 3) = std::nan("");
	EXPECT_EQ(refusal<InvalidCoordinate>(mesh).rfind("1 vertex has", 0), 0u);
	mesh.positions(0, 7) = std::numeric_limits<double>::infinity();
	mesh.positions(1, 7) = std::nan("");
	EXPECT_EQ(refusal<InvalidCoordinate>(mesh).rfind("2 vertices have", 0), 0u);
}

TEST(AssemblePatches, ClosedPatchesAreCounted) {
	TriangleMesh mesh = together(octahedron(), pyramid(Point(5, 0, 0), x, y, 0.3));
	EXPECT_NO_THROW(requireOpenPatches(assembled(pyramid(origin, x, y, 0.3))));
	EXPECT_EQ(messageOf<ClosedPatch>([&] { requireOpenPatches(assembled(mesh)); }).rfind("1 of 2 patches", 0),
			  0u);
	TriangleMesh ball = octahedron();
	ball.positions.colwise() += Point(0, 9, 0);
	mesh = together(mesh, ball);
	const std::string message = messageOf<ClosedPatch>([&] { requireOpenPatches(assembled(mesh)); });
	EXPECT_EQ(message.rfind("2 of 3 patches", 0), 0u) << message;
	EXPECT_NE(message.find("cut"), std::string::npos);
	EXPECT_NE(message.find("seams"), std::string::npos);
	// Only the patches that are worked on count.
	mesh.triangleSelected[8] = 1; // of the pyramid
	EXPECT_NO_THROW(requireOpenPatches(assembled(mesh, selectedOnly())));
}

} // namespace
} // namespace developable::test
