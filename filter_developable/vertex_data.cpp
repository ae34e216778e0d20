// SPDX-License-Identifier: GPL-3.0-or-later
// vertex_data.cpp: vertex quality, colours and custom attributes of a host's mesh.
#include "vertex_data.h"

#include <vcg/complex/allocate.h>

#include <type_traits>

namespace developable::plugin {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;
using Point = vcg::Point3<host::Scalar>;

/// Calls `write(vertex, place)` for every vertex that was worked on.
template <class Write>
void forEachVertex(const PatchAssembly& assembly, Write write) {
	for (std::size_t vertex = 0; vertex < assembly.placeOfVertex.size(); ++vertex)
		if (assembly.placeOfVertex[vertex] >= 0)
			write(vertex, assembly.placeOfVertex[vertex]);
}

/// The attribute of that name; a new one has `initialValue(vertex)` everywhere.
template <class Value, class InitialValue>
auto attribute(CMeshO& mesh, const std::string& name, InitialValue initialValue) {
	auto found = Allocator::FindPerVertexAttribute<Value>(mesh, name);
	if (Allocator::IsValidHandle(mesh, found))
		return found;
	Allocator::DeletePerVertexAttribute(mesh, name);
	auto added = Allocator::AddPerVertexAttribute<Value>(mesh, name);
	for (std::size_t vertex = 0; vertex < mesh.vert.size(); ++vertex)
		added[vertex] = initialValue(mesh.vert[vertex]);
	return added;
}

} // namespace

void writeScalarAttribute(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
						  const Eigen::VectorXd& values) {
	auto scalars = attribute<host::Scalar>(mesh, name, [](const CVertexO&) { return host::Scalar(0); });
	forEachVertex(assembly, [&](std::size_t vertex, int place) {
		scalars[vertex] = narrowed<host::Scalar>(values[place]);
	});
}

void writePointAttribute(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
						 const Positions& points) {
	auto attributePoints = attribute<Point>(mesh, name, [](const CVertexO& vertex) { return vertex.cP(); });
	forEachVertex(assembly, [&](std::size_t vertex, int place) {
		for (int axis = 0; axis < 3; ++axis)
			attributePoints[vertex][axis] =
				narrowed<host::Scalar>(inMeshUnits(assembly.lengthExponent, points(axis, place)));
	});
}

void writeQuality(CMeshO& mesh, const PatchAssembly& assembly, const Eigen::VectorXd& values) {
	forEachVertex(assembly, [&](std::size_t vertex, int place) {
		mesh.vert[vertex].Q() = narrowed<std::decay_t<decltype(mesh.vert[vertex].cQ())>>(values[place]);
	});
}

void writeColours(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<vcg::Color4b>& colours) {
	forEachVertex(assembly, [&](std::size_t vertex, int place) {
		mesh.vert[vertex].C() = colours[std::size_t(place)];
	});
}

std::optional<Positions> readPointAttribute(CMeshO& mesh, const std::string& name,
											const PatchAssembly& assembly) {
	auto found = Allocator::FindPerVertexAttribute<Point>(mesh, name);
	if (!Allocator::IsValidHandle(mesh, found))
		return std::nullopt;
	Positions points(3, assembly.placeCount());
	forEachVertex(assembly, [&](std::size_t vertex, int place) {
		for (int axis = 0; axis < 3; ++axis)
			points(axis, place) = inWorkingUnits(assembly.lengthExponent, double(found[vertex][axis]));
	});
	return points;
}

} // namespace developable::plugin
