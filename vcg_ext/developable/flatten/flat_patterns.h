// SPDX-License-Identifier: GPL-3.0-or-later
// flat_patterns.h: patches laid flat, as patterns to cut and sew, and what there is to say about them.
#pragma once

#include "developable/material/material.h"
#include "developable/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace developable {

/// Two boundary curves that are sewn together: the i-th half edge of the one to the i-th of the other. They
/// may belong to one piece.
struct Seam {
	std::array<int, 2> piece;
	std::array<std::vector<int>, 2> halfEdges;
	std::array<double, 2> length = {0, 0}; ///< in the plane

	double mismatch() const { return std::abs(length[0] - length[1]); }
	/// How much the longer side has to be eased in, as a share of the shorter.
	double ease() const { return mismatch() / std::min(length[0], length[1]); }
};

/// A triangle that has to stretch by this or more, from the pattern to the model, has collapsed in the
/// pattern: it is thinner there than a tenth. How much it stretches says nothing then, and counts as this.
constexpr double collapsedStretch = 9;

/// What flattening did to one patch.
struct FlatPiece {
	int holes = 0;
	int cuts = 0; ///< paths along which it had to be cut open
	double maxEdgeStrain = 0;
	double meanEdgeStrain = 0;
	double elasticEnergy = 0; ///< length²
	double maxStretch = 0;    ///< see FlattenReport
	double maxCompression = 0;
	double beyondBounds = 0; ///< by how much a strain is beyond its bound, at most; 0: all are within
	int worstTriangle = -1;  ///< where that is
	std::array<int, 2> longestSide = {-1, -1}; ///< the ends of its longest seam, or side if it has none
	int flippedFaces = 0;
	int collapsedFaces = 0;
	bool overlapping = false;                  ///< with itself or another piece
	std::vector<std::array<int, 2>> crossings; ///< pairs of half edges of its boundary that cross
	bool converged = false;
	int iterations = 0;
};

/// What flattening did to all of them. *Edge strain* is abs(flattened length − length) / length.
struct FlattenReport {
	int pieces = 0;
	double maxEdgeStrain = 0;
	double meanEdgeStrain = 0;
	double elasticEnergy = 0;   ///< Σ (flattened length − length)², length²
	double maxSeamMismatch = 0; ///< length
	/// The greatest σ1 − 1 of the maps from pattern to model, 0 where none is above 1; see collapsedStretch.
	double maxStretch = 0;
	double maxCompression = 0; ///< the greatest 1 − σ2 alike
	double beyondBounds = 0;   ///< of the pieces' the greatest
	int overlappingPieces = 0;
	int flippedFaces = 0;
	int collapsedFaces = 0;         ///< see collapsedStretch
	bool stopped = false;           ///< by the user: there are no patterns
	std::vector<std::string> notes; ///< what a user should know: cuts, overlaps, limits reached
};

/// One piece per patch of an assembly, in their order. Half edges are those of the assembly.
struct FlatPatterns {
	Eigen::Matrix2Xd positions;      ///< 2 x vertices, the model's unit
	Eigen::Matrix3Xi triangles;      ///< 3 x triangles, in the assembly's order of triangles and corners
	std::vector<int> joinedHalfEdge; ///< as the assembly's, and -1 along cuts too
	std::vector<int> placeOfVertex;  ///< a place has several vertices on seams and cuts
	std::vector<int> pieceOfVertex;
	Eigen::VectorXd edgeStrain;    ///< per vertex, the greatest of its edges
	Eigen::VectorXd elasticEnergy; ///< per vertex, half of that of each of its edges (Fig. 1), length²
	Eigen::VectorXd stretch;       ///< per vertex, the greatest of its triangles; see FlattenReport
	Eigen::VectorXd compression;   ///< alike
	StrainBounds bounds;           ///< that the patterns were made for
	Grain grain = Grain::LongestSeam;
	std::vector<FlatPiece> pieces;
	std::vector<Seam> seams;
	FlattenReport report;

	int vertexCount() const { return static_cast<int>(positions.cols()); }
	int vertexAt(int corner) const { return triangles.data()[corner]; }
	double length(int halfEdge) const {
		return (positions.col(vertexAt(nextCorner(halfEdge))) - positions.col(vertexAt(halfEdge))).norm();
	}
};

/// A map of the patterns' vertices on the model: the largest value where a place has several vertices.
/// \param vertexValues  per vertex of the patterns, none negative
/// \return              per place
Eigen::VectorXd largestAtPlaces(const PatchAssembly& assembly, const FlatPatterns& patterns,
								const Eigen::VectorXd& vertexValues);

} // namespace developable
