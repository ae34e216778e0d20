// SPDX-License-Identifier: GPL-3.0-or-later
// curve_network.h: curves across the triangles of a mesh that meet in their ends only.
#pragma once

#include "cut_surface.h"
#include "smooth_seams.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace developable::detail {

/// Curves run from node to node, straight across a triangle or along one of its edges. Nodes are the
/// vertices and some points on every edge, and others that are asked for.
class CurveNetwork {
public:
	/// \param mesh  its triangles are those of the surface
	CurveNetwork(const TriangleMesh& mesh, const CutSurface& surface);

	/// The node there, a new one if need be.
	int nodeAt(const VertexOrigin& place);
	Eigen::Vector3d pointOf(int node) const;
	/// \return the vertex, or -1 of a node on an edge
	int vertexOf(int node) const { return node < mesh_.vertexCount() ? node : -1; }

	/// Nodes are taken by all curves through them.
	void add(const std::vector<int>& curve);
	void remove(const std::vector<int>& curve);

	/// Triangles that have a node, ascending.
	std::vector<int> trianglesAt(int node) const;
	/// Of a triangle and its sides, those that a further curve may use; none on borders.
	std::vector<int> freeNodes(int triangle) const;
	/// Whether a curve may go straight from one node of a triangle to another.
	bool mayRun(int triangle, int from, int to) const;

	/// The mesh with triangles split along all curves.
	/// \param isCut  gets, per half edge of the result, whether a curve runs there
	SplitMesh split(std::vector<char>& isCut) const;

private:
	struct EdgePoint {
		int halfEdge; ///< the first of the edge
		double share; ///< from its start
	};
	using Segment = std::pair<int, int>; ///< nodes, ascending

	int firstOf(int halfEdge) const;
	EdgePoint edgePointOf(int node) const;
	double placeIn(int triangle, int node) const;
	int sideOf(int triangle, int a, int b) const;
	std::vector<int> takenOn(int side) const;
	bool isInsideSegment(int halfEdge, double share) const;
	std::vector<int> trianglesOfStep(int a, int b) const;
	void change(const std::vector<int>& curve, int by);
	std::vector<int> nodesRound(int triangle) const;
	std::set<Segment> segmentsOf(int triangle) const;
	void splitTriangle(int triangle, const std::map<int, int>& vertexOfNode,
					   std::vector<Eigen::Vector3i>& triangles, SplitMesh& result,
					   std::vector<char>& isCut) const;

	const TriangleMesh& mesh_;
	const PatchAssembly& assembly_;
	Groups cornersAt_;                              // of each vertex
	std::map<std::pair<int, int>, int> halfEdges_;  // by their vertices
	std::vector<EdgePoint> others_;                 // nodes beyond those of every edge
	std::map<int, std::map<double, int>> othersOn_; // by edge and share
	std::map<int, int> taken_;                      // by how many curves
	std::map<int, std::set<int>> takenOn_;          // nodes, by edge
	std::map<int, std::set<Segment>> chords_;       // by triangle
	std::map<int, std::set<Segment>> along_;        // by edge
};

} // namespace developable::detail
