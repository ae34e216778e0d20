// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/vcg_mesh/vcg_mesh.h"

#include "developable/geometry/geometry.h"
#include "support/shapes.h"
#include "support/vcg_meshes.h"

#include <gtest/gtest.h>

#include <memory>

namespace developable::test {
namespace {

template <class MeshType>
class LengthUnit : public testing::Test {
public:
	using Scalar = typename MeshType::ScalarType;

	/// A saddle with coordinates as the scalar has them, times a power of two.
	static Positions sized(int exponent) {
		const Positions shape = rounded<Scalar>(jitteredGrid(6, 6, saddle).positions);
		return shape.unaryExpr([=](double x) { return std::ldexp(x, exponent); });
	}

	static std::unique_ptr<MeshType> meshOfSize(int exponent) {
		auto mesh = std::make_unique<MeshType>();
		TriangleMesh shape = jitteredGrid(6, 6, saddle);
		shape.positions = sized(exponent);
		fill(*mesh, shape);
		return mesh;
	}

	/// Beyond which squares are no numbers.
	static constexpr int smallest = std::is_same_v<Scalar, float> ? -74 : -537,
						 largest = std::is_same_v<Scalar, float> ? 64 : 512;
};

using MeshTypes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(LengthUnit, MeshTypes);

TYPED_TEST(LengthUnit, IsTheMeshsOwnAtOrdinarySizes) {
	for (const int exponent : {-60, -10, 0, 10, 60}) {
		const TriangleMesh read = readTriangles(*this->meshOfSize(exponent));
		EXPECT_EQ(read.lengthExponent, 0);
		EXPECT_EQ(read.positions, this->sized(exponent));
	}
}

TYPED_TEST(LengthUnit, MakesAllSizesTheSameShapeToTheLastBit) {
	const PatchAssembly ordinary = readPatches(*this->meshOfSize(0));
	const Measures expected = measure(ordinary, ordinary.originalPositions, 1e-4);
	for (const int exponent : {this->smallest + 2, -70, this->largest - 1}) {
		const PatchAssembly assembly = readPatches(*this->meshOfSize(exponent));
		const int even = exponent + std::abs(exponent % 2);
		EXPECT_EQ(assembly.lengthExponent, std::abs(exponent) > 64 ? even : 0); // the sheet's size is 1
		const Positions back = inMeshUnits(assembly.lengthExponent, assembly.originalPositions);
		EXPECT_EQ(back, this->sized(exponent));
		const Measures measures = measure(assembly, assembly.originalPositions, 1e-4);
		EXPECT_EQ(measures.totalAbsoluteCurvature, expected.totalAbsoluteCurvature);
		EXPECT_EQ(measures.developability, expected.developability);
	}
}

TYPED_TEST(LengthUnit, IsThatOfWeldDistancesAndOfWhatIsWritten) {
	for (const int exponent : {-70, 0, this->largest - 1}) {
		const auto mesh = this->meshOfSize(exponent);
		PatchOptions options;
		options.weldDistance = std::ldexp(1e-3, exponent); // shorter than every edge
		const PatchAssembly assembly = readPatches(*mesh, options);
		EXPECT_EQ(assembly.placeCount(), 36);
		writePositions(*mesh, assembly, assembly.originalPositions);
		const TriangleMesh again = readTriangles(*mesh);
		EXPECT_EQ(inMeshUnits(again.lengthExponent, again.positions), this->sized(exponent));
	}
}

TYPED_TEST(LengthUnit, OfWhatIsTooLargeOrTooSmallIsRefused) {
	for (const int exponent : {this->smallest - 2, this->largest + 1}) {
		const auto mesh = this->meshOfSize(exponent);
		try {
			readTriangles(*mesh);
			ADD_FAILURE() << exponent;
		} catch (const InvalidCoordinate& error) {
			const std::string advice = exponent > 0 ? "scale it down" : "scale it up";
			EXPECT_NE(std::string(error.what()).find(advice), std::string::npos) << error.what();
		}
	}
}

TEST(InMeshUnits, AreFiniteWhateverTheQuantity) {
	constexpr double most = std::numeric_limits<double>::max();
	EXPECT_EQ(inMeshUnits(3, 5), 40);
	EXPECT_EQ(inMeshUnits(3, 5, -2), 5.0 / 64);
	EXPECT_EQ(inMeshUnits(-531, 1, -2), most); // a curvature of what is 1e-160 long
	EXPECT_EQ(inMeshUnits(-531, -1, -2), -most);
	EXPECT_EQ(inMeshUnits(-531, 0, -2), 0);
	EXPECT_EQ(inMeshUnits(-531, 1e-200, -2), std::ldexp(1e-200, 1062));
	EXPECT_EQ(narrowed<float>(1e39), std::numeric_limits<float>::max());
	EXPECT_EQ(narrowed<float>(-1e39), -std::numeric_limits<float>::max());
	EXPECT_EQ(narrowed<float>(0.1), 0.1F);
}

} // namespace
} // namespace developable::test
