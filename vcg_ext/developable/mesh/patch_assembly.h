// SPDX-License-Identifier: GPL-3.0-or-later
// patch_assembly.h: an object made of patches that are sewn together (Sections 3.1, 4.2), as flat arrays.
#pragma once

#include "triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace developable {

/// One patch M_i: a manifold triangle mesh, with its own copy of every vertex.
struct Patch {
	int triangles = 0;
	int copies = 0;
	int edges = 0;
	int boundaryEdges = 0;
	bool orientable = true;

	int eulerCharacteristic() const { return copies - edges + triangles; }
	bool closed() const { return boundaryEdges == 0; }
};

/// The patches that are worked on. A *place* is a vertex of the object: one linked vertex set, which moves as
/// one. A *copy* is a vertex as one patch sees it. Positions belong to places, so that linked copies can't
/// come apart; angle defects belong to copies.
struct PatchAssembly {
	// Places.
	Positions originalPositions;       ///< 3 x places; linked vertices have gone to their mean
	std::vector<char> placeFixed;      ///< held still by the user, or by a patch that is not worked on
	std::vector<char> placeAssembling; ///< more than one copy of it exists
	std::vector<int> placeOfVertex;    ///< per mesh vertex; -1: not part of the patches worked on

	// Copies.
	std::vector<int> placeOfCopy;
	std::vector<int> patchOfCopy;
	std::vector<char> copyInterior; ///< inside its patch: the copies that have an angle defect
	std::vector<int> cornerStart;   ///< copies + 1: where the corners of each copy begin in `corners`
	std::vector<int> corners;       ///< 3 * triangle + corner, ascending within each copy

	// Triangles and their edges.
	Eigen::Matrix3Xi triangleCopies; ///< 3 x triangles
	Eigen::Matrix3Xi trianglePlaces; ///< 3 x triangles
	std::vector<int> patchOfTriangle;
	std::vector<int> faceOfTriangle;    ///< index among the mesh's faces
	std::vector<char> triangleReversed; ///< its orientation differs from that of its patch's first triangle
	std::vector<int> joinedHalfEdge;    ///< per half edge 3 * triangle + corner the one across it, or -1
	Eigen::Matrix2Xi edgePlaces;        ///< 2 x edges; an edge that two patches share counts once in each
	std::vector<int> edgeHalfEdge;      ///< per edge, its first half edge

	std::vector<Patch> patches;
	double leastHeightRatio = 1e-12; ///< see TriangleMesh
	int lengthExponent = 0;          ///< see TriangleMesh

	/// Of a corner or of the start of a half edge; see indices.h.
	int placeAt(int corner) const { return trianglePlaces.data()[corner]; }
	int copyAt(int corner) const { return triangleCopies.data()[corner]; }
	/// The half edge of the neighbouring triangle, or -1.
	int across(int halfEdge) const { return joinedHalfEdge[halfEdge]; }

	int placeCount() const { return static_cast<int>(originalPositions.cols()); }
	int copyCount() const { return static_cast<int>(placeOfCopy.size()); }
	int triangleCount() const { return static_cast<int>(triangleCopies.cols()); }
	int edgeCount() const { return static_cast<int>(edgePlaces.cols()); }
	int patchCount() const { return static_cast<int>(patches.size()); }
	/// Of a part, which hangs together: whether it has several patches. Sewn together they pull at each
	/// other.
	bool isSewn() const { return patchCount() > 1; }
	int interiorCopyCount() const;
	int assemblingPlaceCount() const;
};

/// Whether some place is held still.
bool holdsPlaces(const PatchAssembly& assembly);

/// The edges' lengths, in the order of edgePlaces.
Eigen::VectorXd edgeLengths(const PatchAssembly& assembly, const Positions& positions);

/// L̄, the mean length of the original edges.
double meanEdgeLength(const PatchAssembly& assembly);

/// The triangles that are lower than the least share of their longest edge: as good as without area.
std::vector<int> zeroAreaTriangles(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
