// SPDX-License-Identifier: GPL-3.0-or-later
// cut_runs.cpp: surfaces cut into panels.
#include "runs.h"

#include "developable/panels/cut_into_panels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace developable::fuzz {

namespace {

TriangleMesh meshOf(const PatchAssembly& assembly) {
	TriangleMesh mesh;
	mesh.positions = assembly.originalPositions;
	mesh.triangles = assembly.trianglePlaces;
	mesh.vertexSelected.assign(assembly.placeCount(), 0);
	mesh.triangleSelected.assign(assembly.triangleCount(), 0);
	for (int t = 0; t < assembly.triangleCount(); ++t)
		mesh.face.push_back(t);
	mesh.leastHeightRatio = assembly.leastHeightRatio;
	return mesh;
}

/// Where the vertices of a cut mesh are, those before and those added.
Positions positionsOf(const CutMesh& cut, const TriangleMesh& before) {
	Positions positions(3, cut.verticesBefore + Eigen::Index(cut.added.size()));
	positions.leftCols(cut.verticesBefore) = before.positions;
	for (std::size_t i = 0; i < cut.added.size(); ++i) {
		const VertexOrigin& origin = cut.added[i];
		positions.col(cut.verticesBefore + Eigen::Index(i)) =
			(1 - origin.share) * before.positions.col(origin.first) +
			origin.share * before.positions.col(origin.second);
	}
	return positions;
}

double areaOf(const Positions& positions, const Eigen::Vector3i& triangle) {
	const Eigen::Vector3d a = positions.col(triangle[1]) - positions.col(triangle[0]);
	const Eigen::Vector3d b = positions.col(triangle[2]) - positions.col(triangle[0]);
	return a.cross(b).norm() / 2;
}

/// That indices are in range, every face is there with all its area, and panels are numbered without gaps.
/// \return whether indices can be used
bool checkCutMesh(const TriangleMesh& before, const CutResult& result, Findings& findings) {
	const CutMesh& cut = result.mesh;
	const int vertices = cut.verticesBefore + static_cast<int>(cut.added.size());
	bool inRange = cut.verticesBefore == before.vertexCount() &&
				   cut.triangles.cols() == Eigen::Index(cut.face.size()) &&
				   cut.triangles.cols() == Eigen::Index(cut.panel.size()) && cut.triangles.minCoeff() >= 0 &&
				   cut.triangles.maxCoeff() < vertices;
	for (const VertexOrigin& origin : cut.added)
		inRange = inRange && origin.first >= 0 && origin.first < before.vertexCount() && origin.second >= 0 &&
				  origin.second < before.vertexCount() && origin.share >= 0 && origin.share <= 1;
	for (const int face : cut.face)
		inRange = inRange && face >= 0 && face < before.triangleCount();
	findings.expect(inRange, "indices out of range in a cut mesh");
	if (!inRange)
		return false;
	const Positions positions = positionsOf(cut, before);
	const double size = boxDiagonal(before.positions);
	std::vector<double> areas(before.triangleCount(), 0);
	for (int t = 0; t < cut.triangles.cols(); ++t)
		areas[cut.face[t]] += areaOf(positions, cut.triangles.col(t));
	for (int face = 0; face < before.triangleCount(); ++face) {
		const double area = areaOf(before.positions, before.triangles.col(face));
		findings.expect(std::abs(areas[face] - area) <= 1e-9 * (area + 1e-6 * size * size),
						"a face is not where it was");
	}
	const std::set<int> panels(cut.panel.begin(), cut.panel.end());
	findings.expect(!panels.empty() && *panels.begin() == 0 &&
						*panels.rbegin() == static_cast<int>(panels.size()) - 1 &&
						panels.size() == result.report.panels.size(),
					"panels with gaps in their numbers");
	return true;
}

/// That what is called developable are panels with a border, each in one piece.
void checkPanels(const TriangleMesh& before, const CutResult& result, Findings& findings) {
	TriangleMesh mesh;
	mesh.positions = positionsOf(result.mesh, before);
	mesh.triangles = result.mesh.triangles;
	mesh.vertexSelected.assign(mesh.vertexCount(), 0);
	mesh.triangleSelected.assign(mesh.triangleCount(), 0);
	for (int t = 0; t < mesh.triangleCount(); ++t)
		mesh.face.push_back(t);
	mesh.leastHeightRatio = 1e-15; // triangles that seams split may be thin
	const PatchAssembly assembly = assemblePatches(mesh, PatchOptions());
	std::set<std::pair<int, int>> pairs;
	for (int t = 0; t < assembly.triangleCount(); ++t)
		pairs.emplace(result.mesh.panel[assembly.faceOfTriangle[t]], assembly.patchOfTriangle[t]);
	findings.expect(pairs.size() == std::size_t(assembly.patchCount()), "two panels are still connected");
	findings.expect(result.report.panels.size() == std::size_t(assembly.patchCount()),
					"a panel in several pieces");
	for (const auto& [panel, patch] : pairs)
		findings.expect(!result.report.panels[panel].developable || !assembly.patches[patch].closed(),
						"a closed panel is called developable");
}

} // namespace

void runCutIntoPanels(Random& random, const PatchAssembly& assembly, Findings& findings) {
	const TriangleMesh mesh = meshOf(assembly);
	const double diagonal = boxDiagonal(mesh.positions);
	CutOptions options;
	options.maxDisplacement = random.oneOf({-1.0, 0.0, 0.05 * diagonal, diagonal});
	options.maxPanels = random.oneOf({0, 0, 1, 3});
	options.darts = random.chance(0.5);
	options.creaseAngle = random.oneOf({40.0, 0.0, 180.0});
	options.splitTriangles = random.chance(0.7);
	if (random.chance(0.05))
		options.creaseAngle = random.oneOf({-1.0, 181.0, std::nan("")});
	int callsUntilStop = random.chance(0.2) ? random.below(20) : -1;
	const Progress progress = [&](double fractionDone, const std::string&) {
		findings.expect(fractionDone >= 0 && fractionDone <= 1,
						"progress of " + std::to_string(fractionDone));
		return callsUntilStop < 0 || callsUntilStop-- > 0;
	};
	const CutResult result = cutIntoPanels(mesh, PatchOptions(), options, progress);
	if (result.report.status == Status::Stopped)
		return;
	const int patchesBefore = assemblePatches(mesh, PatchOptions()).patchCount();
	if (!checkCutMesh(mesh, result, findings))
		return;
	checkPanels(mesh, result, findings);
	findings.expect(options.maxPanels == 0 || result.report.status != Status::Converged ||
						int(result.report.panels.size()) <= std::max(options.maxPanels, patchesBefore),
					std::to_string(result.report.panels.size()) + " panels where " +
						std::to_string(options.maxPanels) + " are wanted of " +
						std::to_string(patchesBefore) + " patches");
	for (const double number : {result.report.seamLength, result.report.smallestPanelArea,
								result.report.meanDisplacement, result.report.maxDisplacement})
		findings.expect(std::isfinite(number) && number >= 0, "a number that is not finite");
}

} // namespace developable::fuzz
