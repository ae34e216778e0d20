// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/mesh.h"

#include "developable/penalty/penalty_method.h"
#include "developable/vcg_mesh/vcg_mesh.h"
#include "support/vcg_meshes.h"

#include "support/patch_checks.h"
#include "support/pyramids.h"

namespace developable::test {
namespace {

template <class MeshType>
class PatchesOfAVcgMesh : public testing::Test {
protected:
	using Scalar = typename MeshType::ScalarType;

	static constexpr bool isFloat = sizeof(Scalar) == 4;

	Positions coordinates() const { return readTriangles(mesh).positions; }

	MeshType mesh;
};

using MeshTypes = testing::Types<FloatMesh, DoubleMesh>;

TYPED_TEST_SUITE(PatchesOfAVcgMesh, MeshTypes);

TYPED_TEST(PatchesOfAVcgMesh, FaceHasNoAreaBelowItsScalarsOwnThreshold) {
	const double threshold = this->isFloat ? 1e-6 : 1e-12;
	for (const double factor : {0.5, 2.0}) {
		fill(this->mesh, fan({0.5, factor * threshold, 0}, {origin, x, y}));
		if (factor < 1) {
			EXPECT_EQ(messageOf<DegenerateTriangle>([this] {
						  readPatches(this->mesh);
					  }).rfind("1 face has no area", 0),
					  0u);
		} else {
			EXPECT_NO_THROW(readPatches(this->mesh));
		}
	}
}

TYPED_TEST(PatchesOfAVcgMesh, WritesOnlyTheVerticesWorkedOn) {
	using Allocator = vcg::tri::Allocator<TypeParam>;
	fill(this->mesh, oneSelectedOfThree());
	this->mesh.face[2].SetS();
	Allocator::AddVertex(this->mesh, typename TypeParam::CoordType(4, 5, 6)); // belongs to nothing
	Allocator::AddVertex(this->mesh, typename TypeParam::CoordType(1, 2, 3));
	Allocator::DeleteVertex(this->mesh, this->mesh.vert.back());
	const Positions before = this->coordinates();
	const PatchAssembly assembly = readPatches(this->mesh, selectedOnly());
	writePositions(this->mesh, assembly, Positions::Constant(3, assembly.placeCount(), 77));
	const Positions after = this->coordinates();
	for (int vertex = 0; vertex < before.cols(); ++vertex) {
		if (vertex < 5) {
			EXPECT_EQ(after.col(vertex), Point::Constant(77));
		} else {
			EXPECT_EQ(after.col(vertex), before.col(vertex));
		}
	}
	EXPECT_EQ(this->mesh.vert[16].cP()[2], 3);
}

TYPED_TEST(PatchesOfAVcgMesh, DeletedFaceOpensAClosedPatch) {
	fill(this->mesh, octahedron());
	EXPECT_THROW(requireOpenPatches(readPatches(this->mesh)), ClosedPatch);
	vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face[0]);
	const PatchAssembly assembly = readPatches(this->mesh);
	EXPECT_NO_THROW(requireOpenPatches(assembly));
	EXPECT_EQ(assembly.interiorCopyCount(), 3);
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	for (int copy = 0; copy < 6; ++copy)
		EXPECT_NEAR(defects[copy], assembly.copyInterior[copy] ? 2 * pi / 3 : 0, 1e-14);
}

TYPED_TEST(PatchesOfAVcgMesh, NoSeamOpensInARun) {
	// A sleeve sewn to itself across a gap, with a yoke on its upper rim whose vertices are its own.
	TriangleMesh yoke = grid(13, 3, [](double u, double v) {
		const Point rim = sleeve(0)(u, 1);
		return Point(rim[0] * (1 + 0.3 * v), rim[1] * (1 + 0.3 * v), rim[2] + 0.1 * v * v);
	});
	const TriangleMesh shape = together(grid(13, 6, sleeve(1e-3)), yoke);
	fill(this->mesh, shape);
	const PatchAssembly assembly = readPatches(this->mesh, welding(1.01e-3));
	EXPECT_EQ(assembly.assemblingPlaceCount(), 12 + 5 + 2);
	Positions positions = assembly.originalPositions;
	PenaltyMethodOptions options;
	options.maxIterations = 5;
	penaltyMethod(assembly, positions, options);
	ASSERT_GT((positions - assembly.originalPositions).cwiseAbs().maxCoeff(), 1e-3);
	writePositions(this->mesh, assembly, positions);
	const Positions written = this->coordinates();
	int linked = 0;
	for (int a = 0; a < written.cols(); ++a)
		for (int b = 0; b < a; ++b)
			if ((shape.positions.col(a) - shape.positions.col(b)).norm() < 1.005e-3) {
				EXPECT_EQ(written.col(a), written.col(b));
				++linked;
			}
	EXPECT_GE(linked, 13 + 5 + 3);
}

} // namespace
} // namespace developable::test
