// SPDX-License-Identifier: GPL-3.0-or-later
// panel_mesh.cpp: flips, boundary loops, angle sums and cuts of a panel.
#include "panel_mesh.h"

#include <utility>

namespace developable::detail {

int countFlipped(const Eigen::Matrix3Xi& triangles, const PlanePositions& positions) {
	int count = 0;
	for (const auto& triangle : triangles.colwise())
		count += !(doubleArea(positions, triangle) > 0);
	return count;
}

std::vector<std::vector<int>> boundaryLoops(const PanelMesh& panel) {
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

Eigen::VectorXd angleSums(const PanelMesh& panel) {
	Eigen::VectorXd sums = Eigen::VectorXd::Zero(panel.vertexCount());
	for (int t = 0; t < panel.triangleCount(); ++t) {
		const TriangleFrame frame = panel.frame(t);
		for (int corner = 0; corner < 3; ++corner)
			sums[panel.triangles(corner, t)] += frame.angle(corner);
	}
	return sums;
}

PanelMesh cutOpen(const PanelMesh& panel, const std::vector<int>& halfEdges) {
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
		const int vertex = copies.number[corner], before = panel.start(corner);
		result.triangles.data()[corner] = vertex;
		result.vertexBefore[vertex] = before;
		result.positions.col(vertex) = panel.positions.col(before);
	}
	return result;
}

} // namespace developable::detail
