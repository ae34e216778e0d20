// SPDX-License-Identifier: GPL-3.0-or-later
// patch_assembler.h: how a PatchAssembly is filled from a mesh, part by part.
#pragma once

#include "joined_faces.h"
#include "linked_vertices.h"
#include "options.h"
#include "patch_assembly.h"

namespace developable::detail {

/// Fills a PatchAssembly from a mesh, part by part.
class PatchAssembler {
public:
	PatchAssembler(const TriangleMesh& mesh, const PatchOptions& options)
		: mesh_(mesh), options_(options), joined_(joinedHalfEdges(mesh)),
		  copies_(numberCopies(mesh, joined_)), patches_(numberPatches(joined_)),
		  places_(numberPlaces(mesh, options.weldDistance)) {}

	PatchAssembly assemble();

private:
	/// Keeps the triangles of the patches that are worked on.
	void chooseTriangles();

	static int renumber(std::vector<int>& newNumber, int old, int& count);

	void numberWhatIsKept();

	void fillTriangles();

	void fillEdges();

	/// Spreads the orientation of each patch's first triangle over the patch.
	void orientTriangles();

	void orientAcross(int halfEdge, std::vector<char>& seen, std::vector<int>& front);

	void fillCorners();

	/// The place among those kept of any mesh vertex, or -1.
	int placeAt(int vertex) const;

	void fillPlaces();

	/// Linked vertices go to their mean, or to that of those which hold still; written so that equal
	/// coordinates stay equal to the last bit.
	void fillPositions();

	void fixPlaces();

	const TriangleMesh& mesh_;
	const PatchOptions& options_;
	std::vector<int> joined_;
	Numbering copies_, patches_, places_; // of the whole mesh
	std::vector<int> triangles_;          // those kept
	std::vector<int> newCopy_, newPlace_, newPatch_, newTriangle_;
	std::vector<char> vertexHeld_; // by a patch that is not worked on
	int copyCount_ = 0, placeCount_ = 0, patchCount_ = 0;
	PatchAssembly result_;
};

} // namespace developable::detail
