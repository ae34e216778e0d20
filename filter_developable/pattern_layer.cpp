// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_layer.cpp: vertices, faces and texture coordinates from patterns.
#include "pattern_layer.h"

#include <vcg/complex/allocate.h>

namespace developable::plugin {

void writePatterns(Layer& layer, const FlatPatterns& patterns, int lengthExponent) {
	CMeshO& mesh = layer.mesh();
	const auto triangleCount = static_cast<std::size_t>(patterns.triangles.cols());
	vcg::tri::Allocator<CMeshO>::AddVertices(mesh, std::size_t(patterns.vertexCount()));
	vcg::tri::Allocator<CMeshO>::AddFaces(mesh, triangleCount);
	const auto coordinate = [&](int axis, int vertex) {
		return narrowed<host::Scalar>(inMeshUnits(lengthExponent, patterns.positions(axis, vertex)));
	};
	for (int vertex = 0; vertex < patterns.vertexCount(); ++vertex)
		mesh.vert[std::size_t(vertex)].P() =
			vcg::Point3<host::Scalar>(coordinate(0, vertex), coordinate(1, vertex), 0);
	for (std::size_t face = 0; face < triangleCount; ++face)
		for (int corner = 0; corner < 3; ++corner)
			mesh.face[face].V(corner) =
				&mesh.vert[std::size_t(patterns.triangles(corner, Eigen::Index(face)))];
	layer.positionsChanged();
}

void writeSeams(Layer& layer, const std::vector<Seam>& seams) {
	using Numbers = vcg::Point3<host::Scalar>;
	CMeshO& mesh = layer.mesh();
	const auto zeros = [&](const char* name) {
		auto added = vcg::tri::Allocator<CMeshO>::AddPerFaceAttribute<Numbers>(mesh, name);
		for (std::size_t face = 0; face < mesh.face.size(); ++face)
			added[face].SetZero();
		return added;
	};
	auto number = zeros("seam"), edge = zeros("seam_edge"), sewnTo = zeros("sewn_to");
	for (std::size_t seam = 0; seam < seams.size(); ++seam)
		for (std::size_t i = 0; i < seams[seam].halfEdges[0].size(); ++i) {
			const int first = seams[seam].halfEdges[0][i], second = seams[seam].halfEdges[1][i];
			number[std::size_t(first / 3)][first % 3] = static_cast<host::Scalar>(seam + 1);
			edge[std::size_t(first / 3)][first % 3] = static_cast<host::Scalar>(i);
			sewnTo[std::size_t(first / 3)][first % 3] = static_cast<host::Scalar>(second);
		}
}

void writeTextureCoordinates(Layer& layer, const PatchAssembly& assembly, const FlatPatterns& patterns) {
	const Eigen::Vector2d origin = patterns.positions.rowwise().minCoeff();
	const double size = (patterns.positions.colwise() - origin).maxCoeff();
	layer.enableTextureCoordinates();
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		auto& face = layer.mesh().face[std::size_t(assembly.faceOfTriangle[std::size_t(t)])];
		for (int corner = 0; corner < 3; ++corner) {
			const Eigen::Vector2d at =
				(patterns.positions.col(patterns.triangles(corner, t)) - origin) / size;
			face.WT(corner).U() = static_cast<float>(at[0]);
			face.WT(corner).V() = static_cast<float>(at[1]);
			face.WT(corner).N() = 0;
		}
	}
}

} // namespace developable::plugin
