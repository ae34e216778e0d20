// SPDX-License-Identifier: GPL-3.0-or-later
// panel_mesh.h: one patch by itself, oriented, as flattening works on it; its boundary loops, and cutting it.
#pragma once

#include "../patch_assembly.h"
#include "corner_geometry.h"
#include "joined_faces.h"

namespace developable::detail {

/// One patch. Half edge h = 3 * triangle + corner runs from that corner to the next one of its triangle.
struct PanelMesh {
	Positions positions;             ///< 3 x vertices, on the model, relative to the panel's middle
	Eigen::Matrix3Xi triangles;      ///< 3 x triangles, counterclockwise seen from outside
	std::vector<int> joinedHalfEdge; ///< per half edge the one across it, or -1
	std::vector<int> vertexBefore;   ///< per vertex, the one that it was before the panel was cut

	int vertexCount() const { return static_cast<int>(positions.cols()); }
	int triangleCount() const { return static_cast<int>(triangles.cols()); }
	int halfEdgeCount() const { return 3 * triangleCount(); }
	int start(int halfEdge) const { return triangles(halfEdge % 3, halfEdge / 3); }
	int end(int halfEdge) const { return start(nextCorner(halfEdge)); }
	double length(int halfEdge) const {
		return (positions.col(end(halfEdge)) - positions.col(start(halfEdge))).norm();
	}
	/// True for one half edge of every edge.
	bool firstOfEdge(int halfEdge) const {
		return joinedHalfEdge[halfEdge] < 0 || halfEdge < joinedHalfEdge[halfEdge];
	}
};

/// How a half edge of the assembly is called in a panel that has the triangle the other way round, and back:
/// the corners 0, 1, 2 become 0, 2, 1, so the half edges 0, 1, 2 become 2, 1, 0.
inline int reversedHalfEdge(int halfEdge) {
	return halfEdge + 2 - 2 * (halfEdge % 3);
}

using PlanePositions = Eigen::Matrix2Xd;

/// Twice the signed area of a triangle in the plane.
inline double doubleArea(const PlanePositions& positions, const Eigen::Ref<const Eigen::Vector3i>& triangle) {
	const Eigen::Vector2d a = positions.col(triangle[1]) - positions.col(triangle[0]);
	const Eigen::Vector2d b = positions.col(triangle[2]) - positions.col(triangle[0]);
	return a[0] * b[1] - a[1] * b[0];
}

/// The triangles of every patch, ascending.
inline std::vector<std::vector<int>> trianglesOfPatches(const PatchAssembly& assembly) {
	std::vector<std::vector<int>> triangles(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		triangles[assembly.patchOfTriangle[t]].push_back(t);
	return triangles;
}

/// Per triangle of the assembly whether it is turned round in its panel: those are that disagree with the
/// larger part of their patch's area, as the outside of the patch is where most of it faces.
inline std::vector<char> triangleTurned(const PatchAssembly& assembly, const Positions& positions) {
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

/// Takes one patch, given by its triangles, out of an assembly. Its vertices are the patch's copies in the
/// order of their first corners.
inline PanelMesh makePanel(const PatchAssembly& assembly, const Positions& positions,
						   const std::vector<int>& triangles, const std::vector<char>& turned,
						   std::vector<int>& panelTriangle) {
	for (std::size_t i = 0; i < triangles.size(); ++i)
		panelTriangle[triangles[i]] = static_cast<int>(i);
	const auto panelHalfEdge = [&](int h) {
		return 3 * panelTriangle[h / 3] + (turned[h / 3] ? reversedHalfEdge(h) : h) % 3;
	};
	PanelMesh panel;
	const int count = static_cast<int>(triangles.size());
	panel.triangles.resize(3, count);
	panel.joinedHalfEdge.resize(3 * count);
	Eigen::Matrix3Xi places(3, count);
	for (const int t : triangles)
		for (int corner = 0; corner < 3; ++corner) {
			const int panelCorner = turned[t] ? (3 - corner) % 3 : corner;
			panel.triangles(panelCorner, panelTriangle[t]) = assembly.triangleCopies(corner, t);
			places(panelCorner, panelTriangle[t]) = assembly.trianglePlaces(corner, t);
			const int across = assembly.joinedHalfEdge[3 * t + corner];
			panel.joinedHalfEdge[panelHalfEdge(3 * t + corner)] = across < 0 ? -1 : panelHalfEdge(across);
		}
	// Copies of a patch need not have consecutive numbers.
	std::vector<int> copies(panel.triangles.reshaped().begin(), panel.triangles.reshaped().end());
	std::sort(copies.begin(), copies.end());
	copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
	panel.positions.resize(3, copies.size());
	for (int corner = 0; corner < 3 * count; ++corner) {
		int& vertex = panel.triangles.data()[corner];
		vertex = static_cast<int>(std::lower_bound(copies.begin(), copies.end(), vertex) - copies.begin());
		panel.positions.col(vertex) = positions.col(places.data()[corner]);
	}
	panel.positions.colwise() -= panel.positions.rowwise().mean().eval();
	panel.vertexBefore.resize(copies.size());
	std::iota(panel.vertexBefore.begin(), panel.vertexBefore.end(), 0);
	return panel;
}

/// The boundary loops as half edges, each in the direction of its triangles: the outer one of a flat panel
/// runs counterclockwise.
inline std::vector<std::vector<int>> boundaryLoops(const PanelMesh& panel) {
	std::vector<int> outgoing(panel.vertexCount(), -1);
	for (int h = 0; h < panel.halfEdgeCount(); ++h)
		if (panel.joinedHalfEdge[h] < 0)
			outgoing[panel.start(h)] = h;
	std::vector<std::vector<int>> loops;
	for (int first = 0; first < panel.vertexCount(); ++first) {
		if (outgoing[first] < 0)
			continue;
		loops.emplace_back();
		for (int vertex = first; outgoing[vertex] >= 0;) {
			const int halfEdge = std::exchange(outgoing[vertex], -1);
			loops.back().push_back(halfEdge);
			vertex = panel.end(halfEdge);
		}
	}
	return loops;
}

/// The sum of the corner angles at every vertex, rad.
inline Eigen::VectorXd angleSums(const PanelMesh& panel) {
	Eigen::VectorXd sums = Eigen::VectorXd::Zero(panel.vertexCount());
	for (const auto& triangle : panel.triangles.colwise()) {
		const TriangleFrame frame(panel.positions.col(triangle[0]), panel.positions.col(triangle[1]),
								  panel.positions.col(triangle[2]));
		for (int corner = 0; corner < 3; ++corner)
			sums[triangle[corner]] += frame.angle(corner);
	}
	return sums;
}

/// The panel cut open along edges, each given by one of its half edges.
inline PanelMesh cutOpen(const PanelMesh& panel, const std::vector<int>& halfEdges) {
	PanelMesh result = panel;
	for (const int h : halfEdges) {
		result.joinedHalfEdge[panel.joinedHalfEdge[h]] = -1;
		result.joinedHalfEdge[h] = -1;
	}
	TriangleMesh mesh;
	mesh.triangles = panel.triangles;
	const Numbering copies = numberCopies(mesh, result.joinedHalfEdge);
	result.positions.resize(3, copies.count);
	result.vertexBefore.resize(copies.count);
	for (int corner = 0; corner < panel.halfEdgeCount(); ++corner) {
		const int vertex = copies.number[corner], before = panel.triangles.data()[corner];
		result.triangles.data()[corner] = vertex;
		result.vertexBefore[vertex] = before;
		result.positions.col(vertex) = panel.positions.col(before);
	}
	return result;
}

} // namespace developable::detail
