// SPDX-License-Identifier: GPL-3.0-or-later
// patch_assembler.h: how a PatchAssembly is filled from a mesh, part by part.
#pragma once

#include "../exceptions.h"
#include "../options.h"
#include "../patch_assembly.h"
#include "joined_faces.h"
#include "linked_vertices.h"

namespace developable::detail {

/// Fills a PatchAssembly from a mesh, part by part.
class PatchAssembler {
public:
	PatchAssembler(const TriangleMesh& mesh, const PatchOptions& options)
		: mesh_(mesh), options_(options), joined_(joinedHalfEdges(mesh)),
		  copies_(numberCopies(mesh, joined_)), patches_(numberPatches(joined_)),
		  places_(numberPlaces(mesh, options.weldDistance)) {}

	PatchAssembly assemble() {
		chooseTriangles();
		numberWhatIsKept();
		fillTriangles();
		fillEdges();
		orientTriangles();
		fillCorners();
		fillPlaces();
		result_.leastHeightRatio = mesh_.leastHeightRatio;
		return std::move(result_);
	}

private:
	/// Keeps the triangles of the patches that are worked on.
	void chooseTriangles() {
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

	static int renumber(std::vector<int>& newNumber, int old, int& count) {
		if (newNumber[old] < 0)
			newNumber[old] = count++;
		return newNumber[old];
	}

	void numberWhatIsKept() {
		newCopy_.assign(copies_.count, -1);
		newPlace_.assign(places_.count, -1);
		newPatch_.assign(patches_.count, -1);
		newTriangle_.assign(mesh_.triangleCount(), -1);
		int triangleCount = 0;
		for (const int t : triangles_) {
			newTriangle_[t] = triangleCount++;
			renumber(newPatch_, patches_.number[t], patchCount_);
			for (int corner = 0; corner < 3; ++corner)
				renumber(newCopy_, copies_.number[3 * t + corner], copyCount_);
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

	void fillTriangles() {
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
				const int copy = newCopy_[copies_.number[3 * source + corner]];
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

	void fillEdges() {
		const int halfEdgeCount = 3 * result_.triangleCount();
		result_.joinedHalfEdge.resize(halfEdgeCount);
		result_.copyInterior.assign(copyCount_, 1);
		for (int h = 0; h < halfEdgeCount; ++h) {
			const int source = 3 * triangles_[h / 3] + h % 3;
			const int across = joined_[source];
			result_.joinedHalfEdge[h] = across < 0 ? -1 : 3 * newTriangle_[across / 3] + across % 3;
			if (across < 0 || source < across)
				result_.edgeHalfEdge.push_back(h);
			Patch& patch = result_.patches[result_.patchOfTriangle[h / 3]];
			patch.edges += across < 0 || source < across;
			if (across >= 0)
				continue;
			++patch.boundaryEdges;
			result_.copyInterior[result_.triangleCopies(h % 3, h / 3)] = 0;
			result_.copyInterior[result_.triangleCopies(nextCorner(h) % 3, h / 3)] = 0;
		}
		result_.edgePlaces.resize(2, result_.edgeHalfEdge.size());
		for (int edge = 0; edge < result_.edgeCount(); ++edge) {
			const int h = result_.edgeHalfEdge[edge];
			result_.edgePlaces(0, edge) = result_.trianglePlaces(h % 3, h / 3);
			result_.edgePlaces(1, edge) = result_.trianglePlaces(nextCorner(h) % 3, h / 3);
		}
	}

	/// Spreads the orientation of each patch's first triangle over the patch.
	void orientTriangles() {
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

	void orientAcross(int halfEdge, std::vector<char>& seen, std::vector<int>& front) {
		const int across = result_.joinedHalfEdge[halfEdge], triangle = halfEdge / 3, other = across / 3;
		// Neighbours of the same orientation run along their edge in opposite directions.
		const bool sameDirection =
			result_.triangleCopies(halfEdge % 3, triangle) == result_.triangleCopies(across % 3, other);
		const char reversed = static_cast<char>(result_.triangleReversed[triangle] ^ sameDirection);
		if (!seen[other]) {
			seen[other] = 1;
			result_.triangleReversed[other] = reversed;
			front.push_back(other);
		} else if (result_.triangleReversed[other] != reversed) {
			result_.patches[result_.patchOfTriangle[triangle]].orientable = false;
		}
	}

	void fillCorners() {
		const auto copies = result_.triangleCopies.reshaped();
		result_.cornerStart.assign(copyCount_ + 1, 0);
		for (const int copy : copies)
			++result_.cornerStart[copy + 1];
		for (int copy = 0; copy < copyCount_; ++copy)
			result_.cornerStart[copy + 1] += result_.cornerStart[copy];
		result_.corners.resize(copies.size());
		std::vector<int> next(result_.cornerStart.begin(), result_.cornerStart.end() - 1);
		for (int corner = 0; corner < copies.size(); ++corner)
			result_.corners[next[copies[corner]]++] = corner;
	}

	/// The place among those kept of any mesh vertex, or -1.
	int placeAt(int vertex) const {
		return places_.number[vertex] < 0 ? -1 : newPlace_[places_.number[vertex]];
	}

	void fillPlaces() {
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

	/// Linked vertices go to their mean, or to that of those which hold still; written so that equal
	/// coordinates stay equal to the last bit.
	void fillPositions() {
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

	void fixPlaces() {
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
