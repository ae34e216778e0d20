// SPDX-License-Identifier: GPL-3.0-or-later
// face_data.cpp: custom attributes of the faces of a host's mesh.
#include "face_data.h"

#include <vcg/complex/allocate.h>

namespace developable::plugin {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;
using Point = vcg::Point3<host::Scalar>;

/// A new attribute of that name, with the initial value everywhere.
template <class Value>
auto attribute(CMeshO& mesh, const std::string& name, const Value& initialValue) {
	Allocator::DeletePerFaceAttribute(mesh, name);
	auto added = Allocator::AddPerFaceAttribute<Value>(mesh, name);
	for (std::size_t face = 0; face < mesh.face.size(); ++face)
		added[face] = initialValue;
	return added;
}

/// Calls `write(face, patch)` for every face that was worked on.
template <class Write>
void forEachFace(const PatchAssembly& assembly, Write write) {
	for (int t = 0; t < assembly.triangleCount(); ++t)
		write(std::size_t(assembly.faceOfTriangle[t]), assembly.patchOfTriangle[t]);
}

} // namespace

void writeFaceScalars(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
					  const Eigen::VectorXd& values, double elsewhere) {
	auto scalars = attribute<host::Scalar>(mesh, name, static_cast<host::Scalar>(elsewhere));
	forEachFace(assembly,
				[&](std::size_t face, int patch) { scalars[face] = narrowed<host::Scalar>(values[patch]); });
}

void writeFacePoints(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
					 const Positions& points) {
	auto facePoints = attribute<Point>(mesh, name, Point(0, 0, 0));
	forEachFace(assembly, [&](std::size_t face, int patch) {
		for (int axis = 0; axis < 3; ++axis)
			facePoints[face][axis] = narrowed<host::Scalar>(points(axis, patch));
	});
}

} // namespace developable::plugin
