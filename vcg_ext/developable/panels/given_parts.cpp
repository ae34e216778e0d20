// SPDX-License-Identifier: GPL-3.0-or-later
// given_parts.cpp: triangles and vertices of each part; numbers that go on from part to part.
#include "given_parts.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

namespace developable::detail {

namespace {

/// Per triangle of the mesh; parts are numbered in the order of their first patches.
std::vector<int> partOfTriangles(const TriangleMesh& mesh) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	const std::vector<AssemblyPart> parts = developable::partsOf(assembly);
	std::vector<int> partOfPatch(assembly.patchCount());
	for (std::size_t part = 0; part < parts.size(); ++part)
		for (const int patch : parts[part].wholePatch)
			partOfPatch[patch] = static_cast<int>(part);
	std::map<int, int> partOfFace;
	for (int t = 0; t < assembly.triangleCount(); ++t)
		partOfFace[assembly.faceOfTriangle[t]] = partOfPatch[assembly.patchOfTriangle[t]];
	std::vector<int> result;
	result.reserve(mesh.triangleCount());
	for (const int face : mesh.face)
		result.push_back(partOfFace.at(face));
	return result;
}

GivenPatches partWith(const GivenPatches& given, const std::vector<int>& triangles) {
	GivenPatches part;
	part.mesh.triangles.resize(3, triangles.size());
	std::map<int, int> numbers;
	std::vector<int> vertices;
	for (std::size_t i = 0; i < triangles.size(); ++i) {
		for (int corner = 0; corner < 3; ++corner) {
			const int vertex = given.mesh.triangles(corner, triangles[i]);
			const auto [number, isNew] = numbers.emplace(vertex, int(vertices.size()));
			if (isNew)
				vertices.push_back(vertex);
			part.mesh.triangles(corner, i) = number->second;
		}
		part.mesh.triangleSelected.push_back(given.mesh.triangleSelected[triangles[i]]);
		part.mesh.face.push_back(given.mesh.face[triangles[i]]);
	}
	part.mesh.positions = given.mesh.positions(Eigen::all, vertices);
	for (const int vertex : vertices) {
		part.mesh.vertexSelected.push_back(given.mesh.vertexSelected[vertex]);
		part.origins.push_back(given.origins[vertex]);
	}
	part.mesh.leastHeightRatio = given.mesh.leastHeightRatio;
	part.mesh.lengthExponent = given.mesh.lengthExponent;
	part.mesh.singlePrecision = given.mesh.singlePrecision;
	part.vertexTaken = given.vertexTaken;
	part.seamLength = lengthOfSharedSides(part);
	return part;
}

/// \param before  triangles are appended to these
void append(CutMesh& before, const CutMesh& part, int panelsBefore) {
	const int addedBefore = static_cast<int>(before.added.size());
	const Eigen::Index trianglesBefore = before.triangles.cols();
	before.verticesBefore = part.verticesBefore;
	before.triangles.conservativeResize(3, trianglesBefore + part.triangles.cols());
	for (Eigen::Index corner = 0; corner < part.triangles.size(); ++corner) {
		const int vertex = part.triangles.data()[corner];
		before.triangles.data()[3 * trianglesBefore + corner] =
			vertex < part.verticesBefore ? vertex : vertex + addedBefore;
	}
	before.added.insert(before.added.end(), part.added.begin(), part.added.end());
	before.face.insert(before.face.end(), part.face.begin(), part.face.end());
	before.seam.insert(before.seam.end(), part.seam.begin(), part.seam.end());
	for (const int panel : part.panel)
		before.panel.push_back(panelsBefore + panel);
}

/// Which one a note is on.
std::string nameOf(const GivenPatches& part, std::size_t number, std::size_t count) {
	const Eigen::Vector3d middle =
		(part.mesh.positions.rowwise().minCoeff() + part.mesh.positions.rowwise().maxCoeff()) / 2;
	char place[96];
	std::snprintf(place, sizeof place, "%.4g, %.4g, %.4g", middle[0], middle[1], middle[2]);
	return "Part " + std::to_string(number + 1) + " of " + std::to_string(count) + ", " +
		   counted(std::size_t(part.mesh.triangleCount()), "face", "faces") + " round (" + place + "): ";
}

/// The worst tells. None were stopped, and no part has a limit of panels.
Status worse(Status a, Status b) {
	for (const Status status : {Status::NeedsCut, Status::Converged})
		if (a == status || b == status)
			return status;
	return Status::NothingToDo;
}

/// \param report  of the parts before; its mean is of so many vertices
void append(CutReport& report, const CutReport& part, double verticesBefore, double vertices) {
	const int panelsBefore = static_cast<int>(report.panels.size());
	report.status = worse(report.status, part.status);
	report.darts += part.darts;
	report.seamLength += part.seamLength;
	report.smallestPanelArea = std::min(report.smallestPanelArea, part.smallestPanelArea);
	report.maxDisplacement = std::max(report.maxDisplacement, part.maxDisplacement);
	report.meanDisplacement = (verticesBefore * report.meanDisplacement + vertices * part.meanDisplacement) /
							  (verticesBefore + vertices);
	for (CutPanel panel : part.panels) {
		if (panel.neighbour >= 0)
			panel.neighbour += panelsBefore;
		report.panels.push_back(panel);
	}
}

} // namespace

std::vector<GivenPatches> partsOf(const GivenPatches& given) {
	const std::vector<int> part = partOfTriangles(given.mesh);
	std::vector<std::vector<int>> triangles(1 + *std::max_element(part.begin(), part.end()));
	for (std::size_t t = 0; t < part.size(); ++t)
		triangles[part[t]].push_back(static_cast<int>(t));
	if (triangles.size() == 1)
		return {given};
	std::vector<GivenPatches> parts;
	parts.reserve(triangles.size());
	for (const std::vector<int>& own : triangles)
		parts.push_back(partWith(given, own));
	return parts;
}

CutResult putTogether(const std::vector<GivenPatches>& parts, const std::vector<CutResult>& results) {
	CutResult whole;
	whole.report.smallestPanelArea = std::numeric_limits<double>::infinity();
	double vertices = 0;
	for (std::size_t i = 0; i < parts.size(); ++i) {
		const double own = parts[i].mesh.vertexCount() + double(results[i].mesh.added.size());
		append(whole.mesh, results[i].mesh, static_cast<int>(whole.report.panels.size()));
		append(whole.report, results[i].report, vertices, own);
		vertices += own;
		for (const std::string& note : results[i].report.notes)
			whole.report.notes.push_back(nameOf(parts[i], i, parts.size()) + note);
	}
	return whole;
}

} // namespace developable::detail
