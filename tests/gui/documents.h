// SPDX-License-Identifier: GPL-3.0-or-later
// documents.h: documents of the host with meshes made in code, and what of a mesh a filter could change.
#pragma once

#include "host.h"

#include "support/shapes.h"

#include <cstring>
#include <vcg/complex/allocate.h>

namespace developable::test {

/// Adds a layer and makes it the current one.
inline MeshModel& addLayer(MeshDocument& document, const TriangleMesh& mesh) {
	MeshModel& layer = *document.addNewMesh("", "panel");
	using Point = CMeshO::CoordType;
	using Scalar = CMeshO::ScalarType;
	for (const auto& position : mesh.positions.colwise())
		vcg::tri::Allocator<CMeshO>::AddVertex(
			layer.cm, Point(Scalar(position[0]), Scalar(position[1]), Scalar(position[2])));
	for (const auto& corners : mesh.triangles.colwise())
		vcg::tri::Allocator<CMeshO>::AddFace(layer.cm, std::size_t(corners[0]), std::size_t(corners[1]),
											 std::size_t(corners[2]));
	plugin::host::updateBoxAndNormals(layer);
	return layer;
}

/// What a filter could change of a layer, to compare with ==.
struct LayerState {
	int dataMask;
	std::vector<plugin::host::Scalar> numbers; ///< positions, normals and qualities
	std::vector<unsigned char> colours;
	std::vector<std::string> attributes;

	explicit LayerState(MeshModel& layer) : dataMask(layer.dataMask()) {
		for (const CVertexO& vertex : layer.cm.vert) {
			for (int axis = 0; axis < 3; ++axis)
				numbers.insert(numbers.end(), {vertex.cP()[axis], vertex.cN()[axis]});
			numbers.push_back(vertex.cQ());
			for (int channel = 0; channel < 4; ++channel)
				colours.push_back(vertex.cC()[channel]);
		}
		for (const auto& attribute : layer.cm.vert_attr)
			attributes.push_back(attribute._name);
	}

	bool operator==(const LayerState& other) const {
		// By their bits, as a normal may be no number, which is not equal to itself.
		const auto sameBits = [](plugin::host::Scalar a, plugin::host::Scalar b) {
			return std::memcmp(&a, &b, sizeof a) == 0;
		};
		return dataMask == other.dataMask && colours == other.colours && attributes == other.attributes &&
			   std::equal(numbers.begin(), numbers.end(), other.numbers.begin(), other.numbers.end(),
						  sameBits);
	}
};

} // namespace developable::test
