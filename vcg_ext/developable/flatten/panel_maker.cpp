// SPDX-License-Identifier: GPL-3.0-or-later
// panel_maker.cpp: which way round triangles are in their panels, and the panels.
#include "panel_maker.h"

#include <algorithm>
#include <numeric>

namespace developable::detail {

std::vector<char> triangleTurned(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd areaBalance = Eigen::VectorXd::Zero(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		const double area =
			TriangleFrame(positions.col(places[0]), positions.col(places[1]), positions.col(places[2]))
				.normal.norm();
		areaBalance[assembly.patchOfTriangle[t]] += assembly.triangleReversed[t] ? -area : area;
	}
	std::vector<char> turned = assembly.triangleReversed;
	for (int t = 0; t < assembly.triangleCount(); ++t)
		turned[t] ^= static_cast<char>(areaBalance[assembly.patchOfTriangle[t]] < 0);
	return turned;
}

PanelMaker::PanelMaker(const PatchAssembly& assembly, const Positions& positions)
	: assembly_(assembly), positions_(positions), turned_(triangleTurned(assembly, positions)),
	  trianglesOfPatch_(grouped(assembly.patchCount(), assembly.triangleCount(),
								[&](int t) { return assembly.patchOfTriangle[t]; })),
	  panelTriangle_(assembly.triangleCount()) {
	for (int patch = 0; patch < assembly.patchCount(); ++patch)
		for (int i = 0; i < trianglesOfPatch_.size(patch); ++i)
			panelTriangle_[trianglesOfPatch_.begin(patch)[i]] = i;
}

PanelMesh PanelMaker::panel(int patch) const {
	PanelMesh panel;
	const int count = trianglesOfPatch_.size(patch);
	panel.triangles.resize(3, count);
	panel.joinedHalfEdge.resize(panel.halfEdgeCount());
	Eigen::Matrix3Xi places(3, count);
	for (int i = 0; i < count; ++i)
		for (int number = 0; number < 3; ++number) {
			const int corner = cornerOf(trianglesOfPatch_.begin(patch)[i], number);
			panel.triangles.data()[panelCorner(corner)] = assembly_.copyAt(corner);
			places.data()[panelCorner(corner)] = assembly_.placeAt(corner);
			const int across = assembly_.across(corner);
			panel.joinedHalfEdge[panelHalfEdge(corner)] = across < 0 ? -1 : panelHalfEdge(across);
		}
	// Copies of a patch need not have consecutive numbers.
	std::vector<int> copies(panel.triangles.reshaped().begin(), panel.triangles.reshaped().end());
	std::sort(copies.begin(), copies.end());
	copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
	panel.positions.resize(3, copies.size());
	for (int corner = 0; corner < panel.halfEdgeCount(); ++corner) {
		int& vertex = panel.triangles.data()[corner];
		vertex = static_cast<int>(std::lower_bound(copies.begin(), copies.end(), vertex) - copies.begin());
		panel.positions.col(vertex) = positions_.col(places.data()[corner]);
	}
	panel.positions.colwise() -= panel.positions.rowwise().mean().eval();
	panel.vertexBefore.resize(copies.size());
	std::iota(panel.vertexBefore.begin(), panel.vertexBefore.end(), 0);
	return panel;
}

} // namespace developable::detail
