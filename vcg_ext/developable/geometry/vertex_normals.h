// SPDX-License-Identifier: GPL-3.0-or-later
// vertex_normals.h: normals of triangles, of vertex copies and of places.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// Normal of every triangle with twice the area as length, turned to the side of its patch's first triangle;
/// 3 x triangles.
Eigen::Matrix3Xd areaNormals(const PatchAssembly& assembly, const Positions& positions);

/// Normal of every triangle of length 1, to the side from which its own corners run counter-clockwise; 3 x
/// triangles.
Eigen::Matrix3Xd unitNormals(const PatchAssembly& assembly, const Positions& positions);

/// The areaNormals of length 1.
Eigen::Matrix3Xd triangleNormals(const PatchAssembly& assembly, const Positions& positions);

/// The average of the unit normals of the triangles round each copy, of length 1, or 0 where they cancel out;
/// 3 x copies.
Eigen::Matrix3Xd copyNormals(const PatchAssembly& assembly, const Positions& positions);

/// A unit normal of every place, 0 where there is none; 3 x places. Sides count for nothing: patches that
/// meet at a place may be turned either way.
Eigen::Matrix3Xd placeNormals(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
