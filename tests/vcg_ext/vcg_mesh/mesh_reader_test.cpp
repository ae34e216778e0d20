// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/vcg_mesh/vcg_mesh.h"

#include "developable/geometry/geometry.h"
#include "developable/local/local_method.h"
#include "developable/penalty/penalty_method.h"
#include "support/shapes.h"
#include "support/vcg_meshes.h"

#include <gtest/gtest.h>
#include <limits>

namespace developable::test {
namespace {

template <class MeshType>
class MeshReader : public testing::Test {
public:
	using Scalar = typename MeshType::ScalarType;
	static constexpr double precision = sizeof(Scalar) == 4 ? 1e-4 : 1e-12; // of an angle defect

	MeshType mesh;
};

using MeshTypes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(MeshReader, MeshTypes);

/// Coordinates of all vertices, to compare a mesh before and after.
template <class MeshType>
Positions coordinates(const MeshType& mesh) {
	return readTriangles(mesh).positions;
}

TYPED_TEST(MeshReader, ReadsPositionsAndTrianglesAsTheyAre) {
	const TriangleMesh shape = jitteredGrid(5, 4, saddle);
	fill(this->mesh, shape);
	const TriangleMesh read = readTriangles(this->mesh);
	EXPECT_EQ(read.triangles, shape.triangles);
	EXPECT_EQ(read.positions, rounded<typename TestFixture::Scalar>(shape.positions));
	EXPECT_EQ(read.singlePrecision, sizeof(typename TestFixture::Scalar) == sizeof(float));
	fill(this->mesh, makeMesh(rounded<float>(shape.positions), shape.triangles));
	EXPECT_TRUE(readTriangles(this->mesh).singlePrecision);
}

TYPED_TEST(MeshReader, LeavesOutDeletedFacesAndVertices) {
	fill(this->mesh, grid(4, 4, flatSheet));
	using Allocator = vcg::tri::Allocator<TypeParam>;
	Allocator::DeleteFace(this->mesh, this->mesh.face[0]);
	Allocator::AddVertex(this->mesh, typename TypeParam::CoordType(9, 9, 9));
	Allocator::DeleteVertex(this->mesh, this->mesh.vert[16]);
	const PatchAssembly assembly = readPatches(this->mesh);
	EXPECT_EQ(assembly.triangleCount(), 17);
	EXPECT_EQ(assembly.faceOfTriangle.front(), 1);
	EXPECT_EQ(assembly.placeOfVertex[16], -1);
	EXPECT_EQ(assembly.placeCount(), 16);
}

TYPED_TEST(MeshReader, WritesBackWhatItRead) {
	fill(this->mesh, jitteredGrid(6, 6, bumpedCylinder));
	const Positions before = coordinates(this->mesh);
	const PatchAssembly assembly = readPatches(this->mesh);
	writePositions(this->mesh, assembly, assembly.originalPositions);
	EXPECT_EQ(coordinates(this->mesh), before);
	Positions shifted = assembly.originalPositions;
	shifted.row(1).array() += 1.0 / 3;
	writePositions(this->mesh, assembly, shifted);
	EXPECT_EQ(coordinates(this->mesh), rounded<typename TestFixture::Scalar>(shifted));
}

TYPED_TEST(MeshReader, MethodsAgreeBetweenScalars) {
	fill(this->mesh, jitteredGrid(9, 9, bumpedCylinder));
	const PatchAssembly assembly = readPatches(this->mesh);
	const PatchAssembly exact = assembled(jitteredGrid(9, 9, bumpedCylinder));
	const auto defects = [](const PatchAssembly& a) { return angleDefects(a, a.originalPositions); };
	EXPECT_LT((defects(assembly) - defects(exact)).cwiseAbs().maxCoeff(), this->precision);
	Positions global = assembly.originalPositions, local = global;
	PenaltyMethodOptions options;
	options.maxIterations = 20;
	penaltyMethod(assembly, global, options);
	localMethod(assembly, local, {});
	const double before = detectFunction(defects(assembly));
	writePositions(this->mesh, assembly, global);
	EXPECT_LT(detectFunction(defects(readPatches(this->mesh))), before);
	writePositions(this->mesh, assembly, local);
	EXPECT_LT(detectFunction(defects(readPatches(this->mesh))), before);
}

TYPED_TEST(MeshReader, KnowsAZeroAreaFaceByTheMeshsOwnPrecision) {
	// Of height 1e-8: nothing in float, something in double.
	TriangleMesh shape = grid(3, 3, flatSheet);
	shape.positions.col(4) = shape.positions.col(0) + Eigen::Vector3d(0.5, 1e-8, 0);
	shape.positions.col(1) = Eigen::Vector3d(1.0, 0, 0);
	shape.positions.col(2) = Eigen::Vector3d(2.0, 0, 0);
	fill(this->mesh, shape);
	if (sizeof(typename TestFixture::Scalar) == 4) {
		EXPECT_THROW(readPatches(this->mesh), DegenerateTriangle);
	} else {
		EXPECT_NO_THROW(readPatches(this->mesh));
	}
}

TYPED_TEST(MeshReader, SaysWhatIsWrongAndHowMuchOfIt) {
	const auto message = [this](const PatchOptions& options = {}) -> std::string {
		try {
			readPatches(this->mesh, options);
		} catch (const Error& error) {
			return error.what();
		}
		return "";
	};
	EXPECT_NE(message().find("no faces"), std::string::npos);
	fill(this->mesh, grid(4, 4, flatSheet));
	EXPECT_EQ(message(), "");
	this->mesh.vert[3].P()[1] = std::numeric_limits<typename TestFixture::Scalar>::quiet_NaN();
	this->mesh.vert[5].P()[2] = std::numeric_limits<typename TestFixture::Scalar>::infinity();
	EXPECT_EQ(message().rfind("2 vertices have a coordinate", 0), 0u) << message();
	fill(this->mesh, grid(4, 4, flatSheet));
	this->mesh.vert[5].P() = this->mesh.vert[6].P(); // the two faces at their edge lose their area
	EXPECT_EQ(message().rfind("2 faces have no area", 0), 0u) << message();
	fill(this->mesh, grid(4, 4, flatSheet));
	PatchOptions selected;
	selected.onlySelected = true;
	EXPECT_NE(message(selected).find("No face is selected"), std::string::npos);
	PatchOptions weld;
	weld.weldDistance = 0.4; // longer than the grid's edges of a third
	EXPECT_NE(message(weld).find("18 triangles"), std::string::npos) << message(weld);
	weld.weldDistance = -1;
	EXPECT_NE(message(weld).find("weld distance"), std::string::npos);
}

TYPED_TEST(MeshReader, FindsSeamsByFaceColourQualityAndTexture) {
	fill(this->mesh, grid(5, 5, flatSheet));
	const auto patches = [this](SeamKind seams) {
		PatchOptions options;
		options.seams = seams;
		return readPatches(this->mesh, options).patchCount();
	};
	for (auto& face : this->mesh.face) {
		const bool left = (face.cP(0)[0] + face.cP(1)[0] + face.cP(2)[0]) / 3 < 0.5;
		const bool lower = (face.cP(0)[1] + face.cP(1)[1] + face.cP(2)[1]) / 3 < 0.5;
		face.C() = left ? vcg::Color4b::Red : vcg::Color4b::Blue;
		face.Q() = static_cast<float>(2 * left + lower);
		for (int corner = 0; corner < 3; ++corner)
			face.WT(corner) = typename TypeParam::FaceType::TexCoordType(
				static_cast<float>(face.cP(corner)[0]) + (lower ? 3 : 0),
				static_cast<float>(face.cP(corner)[1]));
	}
	EXPECT_EQ(patches(SeamKind::ConnectedComponents), 1);
	EXPECT_EQ(patches(SeamKind::FaceColour), 2);
	EXPECT_EQ(patches(SeamKind::TextureIslands), 2);
	EXPECT_EQ(patches(SeamKind::FaceQuality), 4);
	PatchOptions byQuality;
	byQuality.seams = SeamKind::FaceQuality;
	EXPECT_EQ(readPatches(this->mesh, byQuality).assemblingPlaceCount(), 9); // the cross between the quarters
}

TYPED_TEST(MeshReader, CountsFacesWhoseLabelsAreNoNumbers) {
	const auto nan = std::numeric_limits<float>::quiet_NaN();
	const auto message = [this](SeamKind seams) -> std::string {
		try {
			readTriangles(this->mesh, seams);
		} catch (const MissingAttribute& error) {
			return error.what();
		}
		return "";
	};
	fill(this->mesh, grid(4, 4, flatSheet));
	for (auto& face : this->mesh.face) {
		face.Q() = std::numeric_limits<float>::infinity(); // equals itself
		for (int corner = 0; corner < 3; ++corner)
			face.WT(corner) = typename TypeParam::FaceType::TexCoordType(0, 0);
	}
	EXPECT_EQ(message(SeamKind::FaceQuality), "");
	EXPECT_EQ(message(SeamKind::TextureIslands), "");
	this->mesh.face[2].Q() = nan;
	this->mesh.face[5].WT(0).U() = nan;
	this->mesh.face[5].WT(2).V() = nan;
	this->mesh.face[7].WT(1).V() = nan;
	const auto expectTrue = [](const std::string& sentence, const std::string& beginning, int firstFace) {
		EXPECT_EQ(sentence.rfind(beginning, 0), 0u) << sentence;
		EXPECT_EQ(sentence.substr(sentence.find(" See face ")),
				  " See face " + std::to_string(firstFace) + ".");
	};
	expectTrue(message(SeamKind::FaceQuality), "1 face has a quality that is not a number", 2);
	expectTrue(message(SeamKind::TextureIslands), "2 faces have texture coordinates that are not", 5);
	EXPECT_EQ(message(SeamKind::ConnectedComponents), "");
	vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face[5]);
	expectTrue(message(SeamKind::TextureIslands), "1 face has texture coordinates that are not", 7);
	for (const int face : {2, 7})
		vcg::tri::Allocator<TypeParam>::DeleteFace(this->mesh, this->mesh.face[face]);
	EXPECT_EQ(message(SeamKind::FaceQuality) + message(SeamKind::TextureIslands), "");
}

} // namespace
} // namespace developable::test
