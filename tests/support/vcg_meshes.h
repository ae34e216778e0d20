// SPDX-License-Identifier: GPL-3.0-or-later
// vcg_meshes.h: vcg meshes in float and in double, and how tests fill them.
#pragma once

#include "developable/mesh/mesh.h"

#include <vcg/complex/complex.h>

namespace developable::test {

template <class Scalar>
struct MeshOf {
	class Vertex;
	class Face;
	struct Types
		: vcg::UsedTypes<vcg::Use<Vertex>::template AsVertexType, vcg::Use<Face>::template AsFaceType> {};

	template <class Base>
	using Coord = vcg::vertex::Coord<vcg::Point3<Scalar>, Base>;
	template <class Base>
	using Normal = vcg::vertex::Normal<vcg::Point3<Scalar>, Base>;

	class Vertex : public vcg::Vertex<Types, Coord, Normal, vcg::vertex::BitFlags> {};
	class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::WedgeTexCoord2f, vcg::face::Color4b,
								  vcg::face::Qualityf, vcg::face::BitFlags> {};
	class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};
};

using FloatMesh = MeshOf<float>::Mesh;
using DoubleMesh = MeshOf<double>::Mesh;

/// A vcg mesh with the given vertices and triangles.
template <class MeshType>
void fill(MeshType& mesh, const TriangleMesh& shape) {
	using Point = typename MeshType::CoordType;
	mesh.Clear();
	for (const auto& p : shape.positions.colwise())
		vcg::tri::Allocator<MeshType>::AddVertex(mesh, Point(p[0], p[1], p[2]));
	for (const auto& t : shape.triangles.colwise())
		vcg::tri::Allocator<MeshType>::AddFace(mesh, t[0], t[1], t[2]);
}

} // namespace developable::test
