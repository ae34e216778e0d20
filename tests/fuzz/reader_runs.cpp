// SPDX-License-Identifier: GPL-3.0-or-later
// reader_runs.cpp: vcg meshes read into arrays and written back, in float and in double.
#include "runs.h"

#include "developable/vcg_mesh/vcg_mesh.h"
#include "support/vcg_meshes.h"

#include <cmath>
#include <limits>

namespace developable::fuzz {

namespace {

template <class Scalar>
Scalar hostileNumber(Random& random) {
	using Limits = std::numeric_limits<Scalar>;
	return random.oneOf({Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
						 Limits::denorm_min(), Scalar(-0.0)});
}

/// Labels of few values, and now and then what is no number.
template <class Mesh>
void labelFaces(Random& random, Mesh& mesh) {
	const double strange = random.oneOf({0.0, 0.0, 0.1, 1.0});
	const auto number = [&] {
		return random.chance(strange) ? hostileNumber<float>(random) : float(random.below(3));
	};
	for (auto& face : mesh.face) {
		face.C() = random.chance(0.5) ? vcg::Color4b::Red : vcg::Color4b::Blue;
		face.Q() = number();
		for (int corner = 0; corner < 3; ++corner) {
			face.WT(corner).U() = number();
			face.WT(corner).V() = number();
			face.WT(corner).N() = static_cast<short>(random.below(2));
		}
	}
}

/// As a host holds it: of any size, with what was deleted still in its place.
template <class Mesh>
void fillMesh(Random& random, const PatchAssembly& assembly, Mesh& mesh) {
	using Scalar = typename Mesh::ScalarType;
	using Allocator = vcg::tri::Allocator<Mesh>;
	TriangleMesh shape;
	constexpr int largest = std::numeric_limits<Scalar>::max_exponent10;
	const double scale = random.oneOf({1.0, 1.0, random.magnitude(-largest, largest)});
	shape.positions = assembly.originalPositions * scale;
	shape.triangles = assembly.trianglePlaces;
	test::fill(mesh, shape);
	labelFaces(random, mesh);
	const double deleted = random.oneOf({0.0, 0.0, 0.2, 1.0}), selected = random.oneOf({0.0, 0.5});
	for (auto& face : mesh.face) {
		if (random.chance(selected))
			face.SetS();
		if (random.chance(deleted))
			Allocator::DeleteFace(mesh, face);
	}
	if (random.chance(0.1))
		mesh.vert[random.below(int(mesh.vert.size()))].P()[random.below(3)] = hostileNumber<Scalar>(random);
	if (random.chance(0.3)) { // a vertex of no face, and one more that is deleted
		Allocator::AddVertex(mesh, typename Mesh::CoordType(1, 2, 3));
		Allocator::DeleteVertex(mesh, *Allocator::AddVertex(mesh, typename Mesh::CoordType(4, 5, 6)));
	}
}

/// Faces in order without those that are deleted, and coordinates that differ by a power of two only.
template <class Mesh>
void checkRead(const Mesh& mesh, const TriangleMesh& read, Findings& findings) {
	findings.expect(read.triangleCount() == mesh.fn && read.vertexCount() == int(mesh.vert.size()),
					"a wrong number of faces or vertices");
	findings.expect(read.cornerLabel.empty() || int(read.cornerLabel.size()) == 3 * mesh.fn,
					"a wrong number of labels");
	int next = 0;
	for (std::size_t face = 0; face < mesh.face.size(); ++face) {
		if (mesh.face[face].IsD())
			continue;
		findings.expect(read.face[next] == int(face), "a face with another's number");
		for (int corner = 0; corner < 3; ++corner) {
			const auto& vertex = *mesh.face[face].cV(corner);
			const auto at = read.positions.col(read.triangles(corner, next));
			for (int axis = 0; axis < 3; ++axis) {
				const double expected = std::ldexp(double(vertex.cP()[axis]), -read.lengthExponent);
				findings.expect(at[axis] == expected || std::isnan(expected),
								"a coordinate that is not the mesh's");
			}
		}
		++next;
	}
}

template <class Mesh>
void readAndWrite(Random& random, const PatchAssembly& assembly, Findings& findings) {
	Mesh mesh;
	fillMesh(random, assembly, mesh);
	PatchOptions options;
	options.seams = random.oneOf({SeamKind::ConnectedComponents, SeamKind::FaceColour, SeamKind::FaceQuality,
								  SeamKind::TextureIslands});
	options.onlySelected = random.chance(0.2);
	checkRead(mesh, readTriangles(mesh, options.seams), findings);
	const PatchAssembly patches = readPatches(mesh, options);
	const auto before = readTriangles(mesh).positions;
	writePositions(mesh, patches, patches.originalPositions);
	findings.expect(readTriangles(mesh).positions == before, "written back, a coordinate has changed");
}

} // namespace

void runReader(Random& random, const PatchAssembly& assembly, Findings& findings) {
	if (random.chance(0.5))
		readAndWrite<test::FloatMesh>(random, assembly, findings);
	else
		readAndWrite<test::DoubleMesh>(random, assembly, findings);
}

} // namespace developable::fuzz
