// SPDX-License-Identifier: GPL-3.0-or-later
// reference_shape.cpp: reads the reference from another layer or from what an optimisation left on this one.
#include "reference_shape.h"

#include "layer.h"
#include "vertex_data.h"

#include "developable/vcg_mesh/vcg_mesh.h"

namespace developable::plugin {

namespace {

Eigen::Affine3d transformation(const CMeshO& mesh) {
	Eigen::Affine3d result;
	for (int row = 0; row < 4; ++row)
		for (int column = 0; column < 4; ++column)
			result(row, column) = double(mesh.Tr.ElementAt(row, column));
	return result;
}

/// The other layer's points as the current layer's coordinates have them, where they appear on the screen.
Positions inCoordinatesOf(const CMeshO& current, const CMeshO& other, const Positions& points) {
	const Eigen::Affine3d from = transformation(other), to = transformation(current);
	if (from.matrix() == to.matrix())
		return points;
	return (to.inverse() * from) * points;
}

Positions atPlaces(const PatchAssembly& assembly, const Positions& vertices) {
	Positions places(3, assembly.placeCount());
	for (std::size_t vertex = 0; vertex < assembly.placeOfVertex.size(); ++vertex)
		if (assembly.placeOfVertex[vertex] >= 0)
			places.col(assembly.placeOfVertex[vertex]) = vertices.col(Eigen::Index(vertex));
	return places;
}

ReferenceShape fromOtherLayer(const CMeshO& current, const CMeshO& other, const PatchAssembly& assembly) {
	TriangleMesh mesh = readTriangles(other);
	if (mesh.triangleCount() == 0)
		throw EmptyMesh("The layer chosen as 'reference' has no faces to measure to: choose another one.");
	requireFiniteCoordinates(mesh);
	ReferenceShape shape;
	shape.vertices = inCoordinatesOf(current, other, inMeshUnits(mesh.lengthExponent, mesh.positions));
	shape.vertices = inMeshUnits(-assembly.lengthExponent, shape.vertices);
	shape.triangles = mesh.triangles;
	if (mesh.positions.cols() == Eigen::Index(assembly.placeOfVertex.size()))
		shape.places = atPlaces(assembly, shape.vertices);
	return shape;
}

} // namespace

std::optional<ReferenceShape> referenceShape(FilterCall& call, const PatchAssembly& assembly) {
	const CMeshO& chosen = call.values.mesh("reference");
	CMeshO& current = call.layer.mesh();
	if (&chosen != &current)
		return fromOtherLayer(current, chosen, assembly);
	std::optional<Positions> original = readPointAttribute(current, "original_position", assembly);
	if (!original)
		return std::nullopt;
	return ReferenceShape{*original, assembly.trianglePlaces, original};
}

} // namespace developable::plugin
