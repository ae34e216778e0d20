// SPDX-License-Identifier: GPL-3.0-or-later
// What a refusal says of how many elements have a fault, and where the first is, worked out anew.
#include "developable/flatten/flatten.h"
#include "support/patch_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <limits>

namespace developable::test {
namespace {

/// That a sentence counts so many, and names a face of the kind together with its middle.
template <class Condition>
void expectTrue(const std::string& sentence, int count, const TriangleMesh& mesh, const Condition& isOne) {
	EXPECT_EQ(std::atoi(sentence.c_str()), count) << sentence;
	int face = -1;
	Eigen::Vector3d at;
	const char* const found = std::strstr(sentence.c_str(), "See face ");
	ASSERT_NE(found, nullptr) << sentence;
	ASSERT_EQ(std::sscanf(found, "See face %d, at (%lf, %lf, %lf).", &face, &at[0], &at[1], &at[2]), 4)
		<< sentence;
	const auto triangle = std::find(mesh.face.begin(), mesh.face.end(), face) - mesh.face.begin();
	ASSERT_LT(triangle, mesh.triangleCount());
	EXPECT_TRUE(isOne(int(triangle))) << sentence;
	const Eigen::Vector3d middle = mesh.positions(Eigen::all, mesh.triangles.col(triangle)).rowwise().mean() *
								   std::ldexp(1, mesh.lengthExponent);
	EXPECT_LT((at - middle).norm(), 1e-5 * middle.norm()) << sentence;
}

TEST(Refusals, OfZeroAreaFacesAreCountedAndPlaced) {
	TriangleMesh mesh = jitteredGrid(7, 7, wave);
	mesh.positions.col(24) = mesh.positions.col(25); // the two faces at their edge
	for (int& face : mesh.face)
		face = 2 * face + 5; // as if others were deleted
	const auto flat = [&](int t) {
		const auto places = mesh.triangles.col(t);
		return std::count(places.begin(), places.end(), 24) + std::count(places.begin(), places.end(), 25) ==
			   2;
	};
	expectTrue(refusal<DegenerateTriangle>(mesh), 2, mesh, flat);
	mesh.lengthExponent = 300; // of a mesh as large as that
	expectTrue(refusal<DegenerateTriangle>(mesh), 2, mesh, flat);
}

TEST(Refusals, OfAWeldDistanceThatIsTooLongArePlaced) {
	TriangleMesh mesh = jitteredGrid(7, 7, wave);
	mesh.positions.col(24) = 0.99 * mesh.positions.col(25) + 0.01 * mesh.positions.col(24);
	const std::string sentence = refusal<DegenerateTriangle>(mesh, welding(0.01));
	EXPECT_NE(sentence.find(" 2 triangles"), std::string::npos) << sentence;
	expectTrue(sentence.substr(sentence.find("2 triangles")), 2, mesh, [&](int t) {
		const auto places = mesh.triangles.col(t);
		return std::count(places.begin(), places.end(), 24) + std::count(places.begin(), places.end(), 25) ==
			   2;
	});
}

TEST(Refusals, OfClosedPatchesArePlacedInOneOfThem) {
	const TriangleMesh sheet = grid(4, 4, flatSheet);
	TriangleMesh ball = octahedron();
	ball.positions.row(0).array() += 7;
	const TriangleMesh mesh = together(together(sheet, ball), octahedron());
	const PatchAssembly assembly = assembled(mesh);
	const std::string sentence = messageOf<ClosedPatch>([&] { requireOpenPatches(assembly); });
	EXPECT_EQ(sentence.rfind("2 of 3 patches are closed", 0), 0u) << sentence;
	expectTrue(sentence, 2, mesh, [&](int t) { return t >= sheet.triangleCount(); });
}

/// Closed round after a number of half turns.
TriangleMesh band(int halfTurns) {
	constexpr int columns = 13;
	TriangleMesh mesh = grid(columns, 3, [&](double u, double v) -> Eigen::Vector3d {
		const double turn = 2 * pi * u, tilt = halfTurns * turn / 2, radius = 2 + (v - 0.5) * std::cos(tilt);
		return {radius * std::cos(turn), radius * std::sin(turn), (v - 0.5) * std::sin(tilt)};
	});
	for (int& vertex : mesh.triangles.reshaped())
		if (vertex % columns == columns - 1) {
			const int row = vertex / columns;
			vertex = (halfTurns % 2 == 1 ? 2 - row : row) * columns;
		}
	return makeMesh(mesh.positions, mesh.triangles);
}

TEST(Refusals, OfPatchesWithOneSideArePlacedInOneOfThem) {
	const TriangleMesh twisted = band(2);
	TriangleMesh one = band(1), three = band(3);
	one.positions.row(0).array() += 7;
	three.positions.row(1).array() -= 7;
	TriangleMesh mesh = together(together(twisted, one), three);
	const PatchAssembly assembly = assembled(mesh);
	const std::string sentence = messageOf<NonOrientablePatch>([&] { requireOrientablePatches(assembly); });
	expectTrue(sentence, 2, mesh, [&](int t) { return t >= twisted.triangleCount(); });
	EXPECT_EQ(
		messageOf<NonOrientablePatch>([&] { flattenPatches(assembly, assembly.originalPositions, {}); }),
		sentence);
	mesh.triangles.col(twisted.triangleCount() + 5).reverseInPlace(); // however its faces run
	const PatchAssembly turned = assembled(mesh);
	expectTrue(messageOf<NonOrientablePatch>([&] { requireOrientablePatches(turned); }), 2, mesh,
			   [&](int t) { return t >= twisted.triangleCount(); });
	EXPECT_NO_THROW(requireOrientablePatches(assembled(twisted)));
}

TEST(Refusals, OfHandlesArePlacedInOneOfThem) {
	// A torus with a hole, beside a sheet.
	const TriangleMesh torus = grid(9, 9, [](double u, double v) -> Eigen::Vector3d {
		const double a = 2 * pi * u, b = 2 * pi * v, radius = 2 + std::cos(b);
		return {9 + radius * std::cos(a), radius * std::sin(a), std::sin(b)};
	});
	TriangleMesh open = torus;
	for (int& vertex : open.triangles.reshaped())
		vertex = vertex / 9 % 8 * 9 + vertex % 9 % 8;
	open = makeMesh(open.positions, open.triangles.rightCols(open.triangles.cols() - 1).eval());
	const TriangleMesh sheet = grid(4, 4, flatSheet);
	const TriangleMesh mesh = together(sheet, open);
	const PatchAssembly assembly = assembled(mesh);
	const std::string sentence =
		messageOf<PatchWithHandles>([&] { flattenPatches(assembly, assembly.originalPositions, {}); });
	expectTrue(sentence, 1, mesh, [&](int t) { return t >= sheet.triangleCount(); });
}

TEST(Refusals, OfCoordinatesThatAreNoNumbersNameTheFirst) {
	TriangleMesh mesh = grid(5, 5, flatSheet);
	mesh.positions(1, 17) = std::nan("");
	mesh.positions(2, 9) = std::numeric_limits<double>::infinity();
	const std::string sentence = refusal<InvalidCoordinate>(mesh);
	EXPECT_EQ(sentence.rfind("2 vertices have", 0), 0u) << sentence;
	EXPECT_NE(sentence.find("See vertex 9."), std::string::npos) << sentence;
}

} // namespace
} // namespace developable::test
