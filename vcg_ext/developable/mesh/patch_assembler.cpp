// SPDX-License-Identifier: GPL-3.0-or-later
// patch_assembler.cpp: reads connectivity, patches, places and copies off a mesh.
#include "patch_assembler.h"

#include "exceptions.h"
#include "grouping.h"

namespace developable::detail {

PatchAssembly PatchAssembler::assemble() {
	chooseTriangles();
	numberWhatIsKept();
	fillTriangles();
	fillEdges();
	orientTriangles();
	fillCorners();
	fillPlaces();
	result_.leastHeightRatio = mesh_.leastHeightRatio;
	result_.lengthExponent = mesh_.lengthExponent;
	return std::move(result_);
}

void PatchAssembler::chooseTriangles() {
	std::vector<char> kept(patches_.count, !options_.onlySelected);
	if (options_.onlySelected)
		for (int t = 0; t < mesh_.triangleCount(); ++t)
			if (mesh_.triangleSelected[t])
				kept[patches_.number[t]] = 1;
	for (int t = 0; t < mesh_.triangleCount(); ++t)
		if (kept[patches_.number[t]])
			triangles_.push_back(t);
	if (triangles_.empty())
		throw EmptyMesh("No face is selected: select a face of each patch to work on, or switch off "
						"'only selected'.");
}

int PatchAssembler::renumber(std::vector<int>& newNumber, int old, int& count) {
	if (newNumber[old] < 0)
		newNumber[old] = count++;
	return newNumber[old];
}

void PatchAssembler::numberWhatIsKept() {
	newCopy_.assign(copies_.count, -1);
	newPlace_.assign(places_.count, -1);
	newPatch_.assign(patches_.count, -1);
	newTriangle_.assign(mesh_.triangleCount(), -1);
	int triangleCount = 0;
	for (const int t : triangles_) {
		newTriangle_[t] = triangleCount++;
		renumber(newPatch_, patches_.number[t], patchCount_);
		for (int corner = 0; corner < 3; ++corner)
			renumber(newCopy_, copies_.number[cornerOf(t, corner)], copyCount_);
	}
	// Places follow the mesh's own order of vertices.
	std::vector<char> vertexKept(mesh_.vertexCount(), 0);
	for (const int t : triangles_)
		for (int corner = 0; corner < 3; ++corner)
			vertexKept[mesh_.triangles(corner, t)] = 1;
	result_.placeOfVertex.assign(mesh_.vertexCount(), -1);
	for (int vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
		if (vertexKept[vertex])
			result_.placeOfVertex[vertex] = renumber(newPlace_, places_.number[vertex], placeCount_);
}

void PatchAssembler::fillTriangles() {
	const int count = static_cast<int>(triangles_.size());
	result_.triangleCopies.resize(3, count);
	result_.trianglePlaces.resize(3, count);
	result_.patchOfTriangle.resize(count);
	result_.faceOfTriangle.resize(count);
	result_.placeOfCopy.resize(copyCount_);
	result_.patchOfCopy.resize(copyCount_);
	result_.patches.resize(patchCount_);
	for (int t = 0; t < count; ++t) {
		const int source = triangles_[t], patch = newPatch_[patches_.number[source]];
		result_.patchOfTriangle[t] = patch;
		result_.faceOfTriangle[t] = mesh_.face[source];
		++result_.patches[patch].triangles;
		for (int corner = 0; corner < 3; ++corner) {
			const int copy = newCopy_[copies_.number[cornerOf(source, corner)]];
			const int place = result_.placeOfVertex[mesh_.triangles(corner, source)];
			result_.triangleCopies(corner, t) = copy;
			result_.trianglePlaces(corner, t) = place;
			result_.placeOfCopy[copy] = place;
			result_.patchOfCopy[copy] = patch;
		}
	}
	for (const int patch : result_.patchOfCopy)
		++result_.patches[patch].copies;
}

void PatchAssembler::fillEdges() {
	const int halfEdgeCount = 3 * result_.triangleCount();
	result_.joinedHalfEdge.resize(halfEdgeCount);
	result_.copyInterior.assign(copyCount_, 1);
	for (int h = 0; h < halfEdgeCount; ++h) {
		const int source = cornerOf(triangles_[triangleOf(h)], cornerInTriangle(h));
		const int across = joined_[source];
		result_.joinedHalfEdge[h] =
			across < 0 ? -1 : cornerOf(newTriangle_[triangleOf(across)], cornerInTriangle(across));
		if (across < 0 || source < across)
			result_.edgeHalfEdge.push_back(h);
		Patch& patch = result_.patches[result_.patchOfTriangle[triangleOf(h)]];
		patch.edges += across < 0 || source < across;
		if (across >= 0)
			continue;
		++patch.boundaryEdges;
		result_.copyInterior[result_.copyAt(h)] = 0;
		result_.copyInterior[result_.copyAt(nextCorner(h))] = 0;
	}
	result_.edgePlaces.resize(2, result_.edgeHalfEdge.size());
	for (int edge = 0; edge < result_.edgeCount(); ++edge) {
		const int h = result_.edgeHalfEdge[edge];
		result_.edgePlaces(0, edge) = result_.placeAt(h);
		result_.edgePlaces(1, edge) = result_.placeAt(nextCorner(h));
	}
}

void PatchAssembler::orientTriangles() {
	result_.triangleReversed.assign(result_.triangleCount(), 0);
	std::vector<char> seen(result_.triangleCount(), 0);
	for (int first = 0; first < result_.triangleCount(); ++first) {
		if (seen[first])
			continue;
		seen[first] = 1;
		for (std::vector<int> front = {first}; !front.empty();) {
			const int triangle = front.back();
			front.pop_back();
			for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
				if (result_.joinedHalfEdge[h] >= 0)
					orientAcross(h, seen, front);
		}
	}
}

void PatchAssembler::orientAcross(int halfEdge, std::vector<char>& seen, std::vector<int>& front) {
	const int across = result_.joinedHalfEdge[halfEdge], triangle = triangleOf(halfEdge),
			  other = triangleOf(across);
	// Neighbours of the same orientation run along their edge in opposite directions.
	const bool sameDirection = result_.copyAt(halfEdge) == result_.copyAt(across);
	const char reversed = static_cast<char>(result_.triangleReversed[triangle] ^ sameDirection);
	if (!seen[other]) {
		seen[other] = 1;
		result_.triangleReversed[other] = reversed;
		front.push_back(other);
	} else if (result_.triangleReversed[other] != reversed) {
		result_.patches[result_.patchOfTriangle[triangle]].orientable = false;
	}
}

void PatchAssembler::fillCorners() {
	const int cornerCount = static_cast<int>(result_.triangleCopies.size());
	Groups corners = grouped(copyCount_, cornerCount, [this](int corner) { return result_.copyAt(corner); });
	result_.cornerStart = std::move(corners.start);
	result_.corners = std::move(corners.members);
}

int PatchAssembler::placeAt(int vertex) const {
	return places_.number[vertex] < 0 ? -1 : newPlace_[places_.number[vertex]];
}

void PatchAssembler::fillPlaces() {
	vertexHeld_.assign(mesh_.vertexCount(), 0);
	for (int t = 0; t < mesh_.triangleCount(); ++t)
		if (newTriangle_[t] < 0)
			for (const int vertex : mesh_.triangles.col(t))
				vertexHeld_[vertex] = 1;
	fillPositions();
	std::vector<int> copiesAt(places_.count, 0), placeOfAnyCopy(copies_.count);
	for (int corner = 0; corner < 3 * mesh_.triangleCount(); ++corner)
		placeOfAnyCopy[copies_.number[corner]] = places_.number[vertexAt(mesh_, corner)];
	for (const int place : placeOfAnyCopy)
		++copiesAt[place];
	result_.placeAssembling.assign(placeCount_, 0);
	for (int place = 0; place < places_.count; ++place)
		if (newPlace_[place] >= 0 && copiesAt[place] > 1)
			result_.placeAssembling[newPlace_[place]] = 1;
	fixPlaces();
}

void PatchAssembler::fillPositions() {
	std::vector<char> placeHeld(placeCount_, 0);
	for (int vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
		if (placeAt(vertex) >= 0 && vertexHeld_[vertex])
			placeHeld[placeAt(vertex)] = 1;
	Positions sum = Positions::Zero(3, placeCount_);
	Eigen::VectorXd count = Eigen::VectorXd::Zero(placeCount_);
	result_.originalPositions.resize(3, placeCount_);
	for (int vertex = 0; vertex < mesh_.vertexCount(); ++vertex) {
		const int place = placeAt(vertex);
		if (place < 0 || vertexHeld_[vertex] != placeHeld[place])
			continue;
		if (count[place] == 0)
			result_.originalPositions.col(place) = mesh_.positions.col(vertex);
		sum.col(place) += mesh_.positions.col(vertex) - result_.originalPositions.col(place);
		count[place] += 1;
	}
	for (int place = 0; place < placeCount_; ++place)
		result_.originalPositions.col(place) += sum.col(place) / count[place];
}

void PatchAssembler::fixPlaces() {
	result_.placeFixed.assign(placeCount_, 0);
	for (int vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
		if (placeAt(vertex) >= 0 &&
			(vertexHeld_[vertex] || (options_.fixSelected && mesh_.vertexSelected[vertex])))
			result_.placeFixed[placeAt(vertex)] = 1;
	if (options_.fixBoundary)
		for (int copy = 0; copy < copyCount_; ++copy)
			if (!result_.copyInterior[copy])
				result_.placeFixed[result_.placeOfCopy[copy]] = 1;
}

} // namespace developable::detail
