// SPDX-License-Identifier: GPL-3.0-or-later
// planned_surface.cpp: patches apart at the beginning, the mesh with its cuts at the end.
#include "planned_surface.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace developable::detail {

void numberByThemselves(GivenPatches& patches) {
	patches.origins.clear();
	for (int vertex = 0; vertex < patches.mesh.vertexCount(); ++vertex)
		patches.origins.push_back({vertex, vertex, 0});
	patches.mesh.face.resize(patches.mesh.triangleCount());
	std::iota(patches.mesh.face.begin(), patches.mesh.face.end(), 0);
	patches.vertexTaken.assign(patches.mesh.vertexCount(), 0);
}

double lengthOfSharedSides(const GivenPatches& given) {
	std::map<std::pair<int, int>, int> own, shared; // how many triangles have a side
	for (int h = 0; h < 3 * given.mesh.triangleCount(); ++h)
		++own[std::minmax({vertexAt(given.mesh, h), vertexAt(given.mesh, nextCorner(h))})];
	double length = 0;
	for (const auto& [side, triangles] : own) {
		const auto [a, b] = side;
		if (triangles == 1 && ++shared[std::minmax({given.origins[a].first, given.origins[b].first})] == 2)
			length += (given.mesh.positions.col(a) - given.mesh.positions.col(b)).norm();
	}
	return length;
}

GivenPatches separatePatches(const TriangleMesh& mesh, const PatchOptions& patches) {
	GivenPatches result;
	const PatchAssembly given = assemblePatches(mesh, patches);
	std::vector<int> triangleOfFace(mesh.face.empty() ? 0 : mesh.face.back() + 1, -1);
	for (int t = 0; t < mesh.triangleCount(); ++t)
		triangleOfFace[mesh.face[t]] = t;
	result.mesh.positions.resize(3, given.copyCount());
	result.mesh.triangles = given.triangleCopies;
	result.mesh.vertexSelected.assign(given.copyCount(), 0);
	result.mesh.leastHeightRatio = mesh.leastHeightRatio;
	result.mesh.lengthExponent = mesh.lengthExponent;
	result.mesh.singlePrecision = mesh.singlePrecision;
	result.mesh.face = given.faceOfTriangle;
	result.origins.resize(given.copyCount());
	std::vector<char> worked(mesh.triangleCount(), 0);
	for (int corner = 0; corner < 3 * given.triangleCount(); ++corner) {
		const int copy = given.copyAt(corner), t = triangleOfFace[given.faceOfTriangle[triangleOf(corner)]];
		const int vertex = mesh.triangles(cornerInTriangle(corner), t);
		worked[t] = 1;
		result.origins[copy] = {vertex, vertex, 0};
		result.mesh.positions.col(copy) = given.originalPositions.col(given.placeOfCopy[copy]);
		if (cornerInTriangle(corner) == 0)
			result.mesh.triangleSelected.push_back(mesh.triangleSelected[t]);
	}
	result.seamLength = lengthOfSharedSides(result);
	result.vertexTaken.assign(mesh.vertexCount(), 0);
	for (int t = 0; t < mesh.triangleCount(); ++t)
		for (int corner = 0; corner < 3 && !worked[t]; ++corner)
			result.vertexTaken[mesh.triangles(corner, t)] = 1;
	return result;
}

PlannedSurface withPanelsOf(const CutSurface& surface, TriangleMesh mesh, std::vector<VertexOrigin> origins,
							const std::vector<int>& halfEdge) {
	CutSurface same(assemblePatches(mesh, {}));
	std::vector<int> labels;
	for (std::size_t corner = 0; corner < halfEdge.size(); corner += 3)
		labels.push_back(surface.panelOf(triangleOf(halfEdge[corner])));
	same.relabel(labels);
	for (std::size_t h = 0; h < halfEdge.size(); ++h)
		if (surface.isCut(halfEdge[h]) && !same.isCut(static_cast<int>(h)))
			same.setCut(static_cast<int>(h), true);
	return {std::move(mesh), std::move(origins), std::move(same)};
}

CutMesh cutMesh(const PlannedSurface& planned, const std::vector<char>& vertexTaken) {
	CutMesh cut;
	cut.verticesBefore = static_cast<int>(vertexTaken.size());
	std::vector<int> all(planned.surface.assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	const TriangleMesh separate = planned.surface.meshOf(all);
	std::vector<char> taken = vertexTaken;
	std::vector<int> numberOf(separate.vertexCount(), -1);
	cut.triangles.resize(3, all.size());
	for (int corner = 0; corner < 3 * separate.triangleCount(); ++corner) {
		int& number = numberOf[vertexAt(separate, corner)];
		if (number < 0) {
			const VertexOrigin origin = planned.origins[vertexAt(planned.mesh, corner)];
			if (origin.first == origin.second && !taken[origin.first]) {
				number = origin.first;
				taken[number] = 1;
			} else {
				number = cut.verticesBefore + static_cast<int>(cut.added.size());
				cut.added.push_back(origin);
			}
		}
		cut.triangles.data()[corner] = number;
	}
	std::vector<int> dense(planned.surface.panelCount(), -1);
	int panels = 0;
	for (const int t : all) {
		int& panel = dense[planned.surface.panelOf(t)];
		if (panel < 0)
			panel = panels++;
		cut.panel.push_back(panel);
		cut.face.push_back(planned.mesh.face[t]);
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			cut.seam.push_back(planned.surface.isCut(h));
	}
	return cut;
}

TriangleMesh meshAsCut(const PlannedSurface& planned, const std::vector<char>& vertexTaken) {
	const CutMesh cut = cutMesh(planned, vertexTaken);
	const std::vector<int> after = cut.facesAfter(1 + *std::max_element(cut.face.begin(), cut.face.end()));
	TriangleMesh mesh;
	mesh.face.resize(after.size());
	std::iota(mesh.face.begin(), mesh.face.end(), 0);
	std::sort(mesh.face.begin(), mesh.face.end(), [&](int a, int b) { return after[a] < after[b]; });
	mesh.triangles = cut.triangles(Eigen::all, mesh.face);
	mesh.positions = Positions::Zero(3, cut.verticesBefore + int(cut.added.size()));
	for (int corner = 0; corner < int(cut.triangles.size()); ++corner)
		mesh.positions.col(cut.triangles.data()[corner]) =
			planned.surface.positions().col(planned.surface.assembly().placeAt(corner));
	mesh.vertexSelected.assign(mesh.vertexCount(), 0);
	mesh.triangleSelected.assign(mesh.triangleCount(), 0);
	mesh.leastHeightRatio = planned.mesh.leastHeightRatio;
	mesh.lengthExponent = planned.mesh.lengthExponent;
	return mesh;
}

} // namespace developable::detail
