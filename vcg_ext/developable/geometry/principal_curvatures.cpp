// SPDX-License-Identifier: GPL-3.0-or-later
// principal_curvatures.cpp: hands the patches to vcglib's estimator of curvatures.
#include "principal_curvatures.h"

// vcglib 2020.09 forgets to include <set>, and that its estimator needs the complex.
#include <set>
#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/update/curvature_fitting.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable {
namespace {

/// A quadric over a plane has so many; a patch with fewer other vertices says nothing about it.
constexpr int quadricUnknowns = 5;

/// The least of a vcg mesh that its estimator of curvatures asks for.
struct CurvatureMesh {
	class Vertex;
	class Face;
	struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
	class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::VFAdj,
									  vcg::vertex::CurvatureDird, vcg::vertex::BitFlags> {};
	class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::VFAdj,
								  vcg::face::BitFlags> {};
	class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};
};

/// Copies as vertices, so that a seam parts what is fitted on its two sides.
void fill(CurvatureMesh::Mesh& mesh, const PatchAssembly& assembly, const Positions& positions) {
	using Allocator = vcg::tri::Allocator<CurvatureMesh::Mesh>;
	Allocator::AddVertices(mesh, assembly.copyCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const auto p = positions.col(assembly.placeOfCopy[copy]);
		mesh.vert[copy].P() = vcg::Point3d(p[0], p[1], p[2]);
	}
	Allocator::AddFaces(mesh, assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (int corner = 0; corner < 3; ++corner) {
			const int from = assembly.triangleReversed[t] ? 2 - corner : corner;
			mesh.face[t].V(corner) = &mesh.vert[assembly.triangleCopies(from, t)];
		}
}

} // namespace

PrincipalCurvatures principalCurvatures(const PatchAssembly& assembly, const Positions& positions) {
	// The fit has thresholds of its own, so it sees every model at the same scale.
	const double scale = meanEdgeLength(assembly);
	CurvatureMesh::Mesh mesh;
	fill(mesh, assembly, positions / scale);
	using Mesh = CurvatureMesh::Mesh;
	vcg::tri::UpdateTopology<Mesh>::VertexFace(mesh);
	vcg::tri::UpdateNormal<Mesh>::PerVertexNormalizedPerFaceNormalized(mesh);
	vcg::tri::UpdateCurvatureFitting<Mesh>::computeCurvature(mesh);
	PrincipalCurvatures result{Eigen::VectorXd::Zero(assembly.copyCount()),
							   Eigen::VectorXd::Zero(assembly.copyCount())};
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const double first = std::abs(mesh.vert[copy].K1()) / scale,
					 second = std::abs(mesh.vert[copy].K2()) / scale;
		const bool fits = assembly.patches[assembly.patchOfCopy[copy]].copies > quadricUnknowns;
		if (!fits || !std::isfinite(first) || !std::isfinite(second))
			continue;
		result.least[copy] = std::min(first, second);
		result.greatest[copy] = std::max(first, second);
	}
	return result;
}

} // namespace developable
