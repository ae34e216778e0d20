// SPDX-License-Identifier: GPL-3.0-or-later
// vertex_normals.h: unit normals of triangles and of vertex copies.
#pragma once

#include "../patch_assembly.h"
#include "corner_geometry.h"

namespace developable::detail {

/// Unit normal of every triangle, turned to the side of its patch's first triangle; 3 x triangles.
inline Eigen::Matrix3Xd triangleNormals(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd normals(3, assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		const TriangleFrame frame(positions.col(places[0]), positions.col(places[1]),
								  positions.col(places[2]));
		normals.col(t) = frame.normal.normalized() * (assembly.triangleReversed[t] ? -1 : 1);
	}
	return normals;
}

/// The average of the unit normals of the triangles round each copy, of length 1, or 0 where they cancel out;
/// 3 x copies.
inline Eigen::Matrix3Xd copyNormals(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd triangles = triangleNormals(assembly, positions);
	Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, assembly.copyCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (const int copy : assembly.triangleCopies.col(t))
			normals.col(copy) += triangles.col(t);
	for (auto normal : normals.colwise())
		normal = normal.norm() > 1e-9 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
	return normals;
}

/// A unit normal of every place, 0 where there is none; 3 x places. Sides count for nothing: patches that
/// meet at a place may be turned either way.
inline Eigen::Matrix3Xd placeNormals(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd triangles = triangleNormals(assembly, positions);
	Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, assembly.placeCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (const int place : assembly.trianglePlaces.col(t))
			normals.col(place) += (normals.col(place).dot(triangles.col(t)) < 0 ? -1 : 1) * triangles.col(t);
	for (auto normal : normals.colwise())
		normal = normal.norm() > 1e-9 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
	return normals;
}

} // namespace developable::detail
