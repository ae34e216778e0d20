// SPDX-License-Identifier: GPL-3.0-or-later
// vertex_normals.cpp: normals of triangles, and their averages.
#include "vertex_normals.h"

#include "triangle_kernel.h"

#include <Eigen/Geometry>

namespace developable {
namespace {

/// Makes normals as long as 1, or 0 those which have next to no length.
void normalize(Eigen::Matrix3Xd& normals) {
	for (auto normal : normals.colwise())
		normal = normal.norm() > 1e-9 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
}

} // namespace

Eigen::Matrix3Xd areaNormals(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd normals(3, assembly.triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		const Eigen::Vector3d a = positions.col(places[1]) - positions.col(places[0]);
		const Eigen::Vector3d b = positions.col(places[2]) - positions.col(places[0]);
		normals.col(t) = (assembly.triangleReversed[t] ? -1 : 1) * a.cross(b);
	}
	return normals;
}

Eigen::Matrix3Xd unitNormals(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd normals(3, assembly.triangleCount());
	detail::runWide(detail::NormalKernel{positions.data(), assembly.trianglePlaces.data(),
										 assembly.triangleCount(), normals.data()});
	return normals;
}

Eigen::Matrix3Xd triangleNormals(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd normals = areaNormals(assembly, positions);
	for (auto normal : normals.colwise())
		normal = Eigen::Vector3d(normal).normalized();
	return normals;
}

Eigen::Matrix3Xd copyNormals(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd triangles = triangleNormals(assembly, positions);
	Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, assembly.copyCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (const int copy : assembly.triangleCopies.col(t))
			normals.col(copy) += triangles.col(t);
	normalize(normals);
	return normals;
}

Eigen::Matrix3Xd placeNormals(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd triangles = triangleNormals(assembly, positions);
	Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, assembly.placeCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (const int place : assembly.trianglePlaces.col(t))
			normals.col(place) += (normals.col(place).dot(triangles.col(t)) < 0 ? -1 : 1) * triangles.col(t);
	normalize(normals);
	return normals;
}

} // namespace developable
