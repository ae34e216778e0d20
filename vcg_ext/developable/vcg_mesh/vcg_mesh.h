// SPDX-License-Identifier: GPL-3.0-or-later
// vcg_mesh.h: the front door of vcg_mesh/, the only place that walks a vcg mesh: reads it into arrays and
// writes positions back. All of it is templates, for any version of vcglib and any type of mesh.
#pragma once

#include "developable/mesh/mesh.h"

#include <vcg/complex/complex.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace developable {
namespace detail {

/// Gives equal keys equal numbers.
template <class Key>
class Labels {
public:
	int operator()(const Key& key) {
		return numbers_.emplace(key, static_cast<int>(numbers_.size())).first->second;
	}

private:
	std::map<Key, int> numbers_;
};

template <class FaceType>
auto colourKey(const FaceType& face) {
	const auto& colour = face.cC();
	return std::make_tuple(colour[0], colour[1], colour[2], colour[3]);
}

/// \param whole  says of a face whether what its label is made of are numbers: others equal nothing
template <class MeshType, class Condition>
void requireNumbers(const MeshType& mesh, const Condition& whole, const std::string& what) {
	const std::vector<int> invalid = indicesWhere(
		int(mesh.face.size()), [&](int face) { return !mesh.face[face].IsD() && !whole(mesh.face[face]); });
	if (!invalid.empty())
		throw MissingAttribute(counted(invalid.size(), "face has ", "faces have ") + what + " See face " +
							   std::to_string(invalid.front()) + ".");
}

/// The labels of a mesh's corners, which say where its seams are (see TriangleMesh::cornerLabel).
template <class MeshType>
std::vector<int> cornerLabels(const MeshType& mesh, SeamKind seams) {
	std::vector<int> labels;
	const auto append = [&](auto labelOf) {
		for (const auto& face : mesh.face)
			for (int corner = 0; !face.IsD() && corner < 3; ++corner)
				labels.push_back(labelOf(face, corner));
	};
	switch (seams) {
	case SeamKind::ConnectedComponents:
		break;
	case SeamKind::FaceColour:
		if (!vcg::tri::HasPerFaceColor(mesh))
			throw MissingAttribute("The mesh has no face colours to tell patches by: colour its faces, or "
								   "choose other patches.");
		append([label = Labels<decltype(colourKey(mesh.face[0]))>()](const auto& face, int) mutable {
			return label(colourKey(face));
		});
		break;
	case SeamKind::TextureIslands:
		if (!vcg::tri::HasPerWedgeTexCoord(mesh))
			throw MissingAttribute("The mesh has no texture coordinates per face corner to tell patches by: "
								   "parameterize it, or choose other patches.");
		requireNumbers(
			mesh,
			[](const auto& face) {
				bool whole = true;
				for (int corner = 0; corner < 3; ++corner)
					whole &= !std::isnan(face.cWT(corner).U()) && !std::isnan(face.cWT(corner).V());
				return whole;
			},
			"texture coordinates that are not numbers: parameterize the mesh anew, or do without them.");
		append([label = Labels<std::tuple<double, double, int>>()](const auto& face, int corner) mutable {
			const auto& texture = face.cWT(corner);
			return label(std::make_tuple(double(texture.U()), double(texture.V()), int(texture.N())));
		});
		break;
	case SeamKind::FaceQuality:
		if (!vcg::tri::HasPerFaceQuality(mesh))
			throw MissingAttribute(
				"The mesh has no face quality to tell patches by: compute one, or choose other patches.");
		requireNumbers(
			mesh, [](const auto& face) { return !std::isnan(face.cQ()); },
			"a quality that is not a number: compute it anew, or choose other patches.");
		append(
			[label = Labels<double>()](const auto& face, int) mutable { return label(double(face.cQ())); });
		break;
	}
	return labels;
}

} // namespace detail

/// Coordinates in the unit that they are best worked with.
/// \throws InvalidCoordinate  when the square of the mesh's size is beyond the numbers that its scalar has,
/// so
///                            that the host can't measure it either
template <class Scalar>
void chooseUnit(TriangleMesh& mesh) {
	const int exponent = lengthExponent(mesh.positions, mesh.triangles);
	constexpr int largest = std::numeric_limits<Scalar>::max_exponent / 2,
				  smallest =
					  (std::numeric_limits<Scalar>::min_exponent - std::numeric_limits<Scalar>::digits) / 2;
	if (exponent > largest || exponent < smallest)
		throw InvalidCoordinate("The mesh is about 1e" +
								std::to_string(std::lround(exponent * std::log10(2))) +
								" long, and the square of that is no number that the host has: scale it " +
								(exponent > 0 ? "down." : "up."));
	mesh.lengthExponent = exponent;
	if (exponent != 0)
		mesh.positions = mesh.positions.unaryExpr([=](double x) { return inWorkingUnits(exponent, x); });
}

/// Reads a vcg mesh of any scalar into arrays. Deleted vertices keep their column; deleted faces are left
/// out.
/// \throws MissingAttribute   when the mesh lacks what the seams are told by, or has no numbers there
/// \throws InvalidCoordinate  when it is too large or too small; see chooseUnit
template <class MeshType>
TriangleMesh readTriangles(const MeshType& mesh, SeamKind seams = SeamKind::ConnectedComponents) {
	TriangleMesh result;
	constexpr bool isFloat = std::is_same_v<typename MeshType::ScalarType, float>;
	if (isFloat)
		result.leastHeightRatio = 1e-6; // heights are lost sooner
	const int vertexCount = static_cast<int>(mesh.vert.size());
	result.positions = Positions::Zero(3, vertexCount);
	result.vertexSelected.assign(vertexCount, 0);
	for (int vertex = 0; vertex < vertexCount; ++vertex) {
		const auto& source = mesh.vert[vertex];
		if (source.IsD())
			continue;
		result.positions.col(vertex) << source.cP()[0], source.cP()[1], source.cP()[2];
		result.vertexSelected[vertex] = source.IsS();
	}
	result.singlePrecision = isFloat || result.positions == rounded<float>(result.positions);
	result.triangles.resize(3, mesh.fn);
	result.triangleSelected.reserve(mesh.fn);
	result.face.reserve(mesh.fn);
	for (std::size_t face = 0; face < mesh.face.size(); ++face) {
		const auto& source = mesh.face[face];
		if (source.IsD())
			continue;
		for (int corner = 0; corner < 3; ++corner)
			result.triangles(corner, result.face.size()) =
				static_cast<int>(vcg::tri::Index(mesh, source.cV(corner)));
		result.triangleSelected.push_back(source.IsS());
		result.face.push_back(static_cast<int>(face));
	}
	result.cornerLabel = detail::cornerLabels(mesh, seams);
	chooseUnit<typename MeshType::ScalarType>(result);
	return result;
}

/// Reads a vcg mesh into patches; see assemblePatches and readTriangles for what is thrown.
/// \param options  with lengths in the mesh's own unit
template <class MeshType>
PatchAssembly readPatches(const MeshType& mesh, const PatchOptions& options = {}) {
	const TriangleMesh read = readTriangles(mesh, options.seams);
	PatchOptions inUnits = options;
	inUnits.weldDistance = inWorkingUnits(read.lengthExponent, options.weldDistance);
	return assemblePatches(read, inUnits);
}

/// Writes the places' positions to all their mesh vertices; other vertices are left alone.
template <class MeshType>
void writePositions(MeshType& mesh, const PatchAssembly& assembly, const Positions& positions) {
	using Scalar = typename MeshType::ScalarType;
	for (std::size_t vertex = 0; vertex < assembly.placeOfVertex.size(); ++vertex) {
		const int place = assembly.placeOfVertex[vertex];
		if (place < 0)
			continue;
		for (int axis = 0; axis < 3; ++axis)
			mesh.vert[vertex].P()[axis] =
				narrowed<Scalar>(inMeshUnits(assembly.lengthExponent, positions(axis, place)));
	}
}

} // namespace developable
