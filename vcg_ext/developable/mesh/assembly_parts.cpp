// SPDX-License-Identifier: GPL-3.0-or-later
// assembly_parts.cpp: which patches hang together, and everything of an assembly that belongs to them.
#include "assembly_parts.h"

#include "disjoint_sets.h"
#include "grouping.h"
#include "indices.h"

#include <algorithm>
#include <functional>

namespace developable {

namespace {

/// The part of each patch.
Numbering numberParts(const PatchAssembly& whole) {
	DisjointSets patches(whole.patchCount());
	std::vector<int> patchAtPlace(whole.placeCount(), -1);
	for (int copy = 0; copy < whole.copyCount(); ++copy) {
		int& other = patchAtPlace[whole.placeOfCopy[copy]];
		if (other < 0)
			other = whole.patchOfCopy[copy];
		else
			patches.unite(other, whole.patchOfCopy[copy]);
	}
	return patches.numbering();
}

/// Numbers of elements within their part, and back.
struct Renumbering {
	Groups members;                ///< per part, elements of the whole
	std::vector<int> numberInPart; ///< per element of the whole

	template <class PartOf>
	Renumbering(int parts, int elements, const PartOf& partOf)
		: members(grouped(parts, elements, partOf)), numberInPart(elements) {
		for (int part = 0; part < parts; ++part)
			for (int i = 0; i < members.size(part); ++i)
				numberInPart[members.begin(part)[i]] = i;
	}

	std::vector<int> of(int part) const { return {members.begin(part), members.end(part)}; }
};

template <class Value>
std::vector<Value> chosen(const std::vector<Value>& values, const std::vector<int>& elements) {
	std::vector<Value> result(elements.size());
	std::transform(elements.begin(), elements.end(), result.begin(), [&](int i) { return values[i]; });
	return result;
}

std::function<int(int)> partOfPlace(const PatchAssembly& whole, const Numbering& parts) {
	std::vector<int> part(whole.placeCount());
	for (int copy = 0; copy < whole.copyCount(); ++copy)
		part[whole.placeOfCopy[copy]] = parts.number[whole.patchOfCopy[copy]];
	return [part](int place) { return part[place]; };
}

/// Puts a part together.
class PartMaker {
public:
	PartMaker(const PatchAssembly& whole, const Numbering& parts)
		: whole_(whole), patches_(parts.count, whole.patchCount(), [&](int p) { return parts.number[p]; }),
		  copies_(parts.count, whole.copyCount(), [&](int c) { return parts.number[whole.patchOfCopy[c]]; }),
		  places_(parts.count, whole.placeCount(), partOfPlace(whole, parts)),
		  triangles_(parts.count, whole.triangleCount(),
					 [&](int t) { return parts.number[whole.patchOfTriangle[t]]; }),
		  edges_(parts.count, whole.edgeCount(), [&](int e) {
			  return parts.number[whole.patchOfTriangle[triangleOf(whole.edgeHalfEdge[e])]];
		  }) {}

	AssemblyPart part(int number) const {
		AssemblyPart result;
		result.wholePlace = places_.of(number);
		result.wholePatch = patches_.of(number);
		PatchAssembly& assembly = result.assembly;
		assembly.patches = chosen(whole_.patches, result.wholePatch);
		assembly.leastHeightRatio = whole_.leastHeightRatio;
		assembly.lengthExponent = whole_.lengthExponent;
		assembly.originalPositions = whole_.originalPositions(Eigen::all, result.wholePlace);
		assembly.placeFixed = chosen(whole_.placeFixed, result.wholePlace);
		assembly.placeAssembling = chosen(whole_.placeAssembling, result.wholePlace);
		fillCopies(copies_.of(number), assembly);
		fillTriangles(triangles_.of(number), assembly);
		fillEdges(edges_.of(number), assembly);
		return result;
	}

private:
	/// Of a corner or half edge of the whole, or -1.
	int cornerInPart(int corner) const {
		return corner < 0 ? -1
						  : cornerOf(triangles_.numberInPart[triangleOf(corner)], cornerInTriangle(corner));
	}

	void fillCopies(const std::vector<int>& copies, PatchAssembly& assembly) const {
		assembly.copyInterior = chosen(whole_.copyInterior, copies);
		assembly.cornerStart = {0};
		for (const int copy : copies) {
			assembly.placeOfCopy.push_back(places_.numberInPart[whole_.placeOfCopy[copy]]);
			assembly.patchOfCopy.push_back(patches_.numberInPart[whole_.patchOfCopy[copy]]);
			for (int i = whole_.cornerStart[copy]; i < whole_.cornerStart[copy + 1]; ++i)
				assembly.corners.push_back(cornerInPart(whole_.corners[i]));
			assembly.cornerStart.push_back(static_cast<int>(assembly.corners.size()));
		}
	}

	void fillTriangles(const std::vector<int>& triangles, PatchAssembly& assembly) const {
		assembly.faceOfTriangle = chosen(whole_.faceOfTriangle, triangles);
		assembly.triangleReversed = chosen(whole_.triangleReversed, triangles);
		assembly.triangleCopies = whole_.triangleCopies(Eigen::all, triangles);
		assembly.trianglePlaces = whole_.trianglePlaces(Eigen::all, triangles);
		for (int& copy : assembly.triangleCopies.reshaped())
			copy = copies_.numberInPart[copy];
		for (int& place : assembly.trianglePlaces.reshaped())
			place = places_.numberInPart[place];
		for (const int triangle : triangles) {
			assembly.patchOfTriangle.push_back(patches_.numberInPart[whole_.patchOfTriangle[triangle]]);
			for (int corner = 0; corner < 3; ++corner)
				assembly.joinedHalfEdge.push_back(
					cornerInPart(whole_.joinedHalfEdge[cornerOf(triangle, corner)]));
		}
	}

	void fillEdges(const std::vector<int>& edges, PatchAssembly& assembly) const {
		assembly.edgePlaces = whole_.edgePlaces(Eigen::all, edges);
		for (int& place : assembly.edgePlaces.reshaped())
			place = places_.numberInPart[place];
		for (const int edge : edges)
			assembly.edgeHalfEdge.push_back(cornerInPart(whole_.edgeHalfEdge[edge]));
	}

	const PatchAssembly& whole_;
	const Renumbering patches_, copies_, places_, triangles_, edges_;
};

} // namespace

std::vector<AssemblyPart> partsOf(const PatchAssembly& whole) {
	const Numbering parts = numberParts(whole);
	const PartMaker maker(whole, parts);
	std::vector<AssemblyPart> result;
	result.reserve(parts.count);
	for (int part = 0; part < parts.count; ++part)
		result.push_back(maker.part(part));
	return result;
}

} // namespace developable
