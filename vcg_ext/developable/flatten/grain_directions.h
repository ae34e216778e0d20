// SPDX-License-Identifier: GPL-3.0-or-later
// grain_directions.h: which way the grain runs in a pattern.
#pragma once

#include "flat_patterns.h"

#include "developable/material/material.h"

#include <array>

namespace developable {

/// The direction in which points in the plane lie farthest apart, upwards.
Eigen::Vector2d principalDirection(const Eigen::Matrix2Xd& points);

/// The direction of the warp in one piece, rad.
/// \param triangles    of the piece
/// \param longestSide  the ends of its longest seam or side among the columns of `flat`; -1: it has none
double grainDirection(const StrainedTriangles& triangles, const Positions& shaped,
					  const Eigen::Matrix2Xd& flat, const Grain& grain,
					  const std::array<int, 2>& longestSide);

/// The triangles of a model and of its patterns, turned round where they run clockwise in the plane, with the
/// grain where the patterns' bounds are directed. Weights are shares of the model's area.
/// \param model  3 x places
StrainedTriangles strainedTriangles(const PatchAssembly& assembly, const Positions& model,
									const FlatPatterns& patterns);

/// By how much each triangle is beyond the bounds that the patterns were made for, as a strain; 0 within.
Eigen::VectorXd beyondBounds(const PatchAssembly& assembly, const Positions& model,
							 const FlatPatterns& patterns);

/// The triangles of one piece.
StrainedTriangles trianglesOfPiece(const StrainedTriangles& all, const PatchAssembly& assembly, int piece);

} // namespace developable
