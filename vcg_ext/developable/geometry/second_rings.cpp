// SPDX-License-Identifier: GPL-3.0-or-later
// second_rings.cpp: fans in order, and samples of them.
#include "second_rings.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

SecondRings::SecondRings(const PatchAssembly& assembly)
	: assembly_(assembly), fans_(assembly.corners.size()), rankOfCorner_(assembly.corners.size()) {
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		orderFan(copy);
}

void SecondRings::walk(int corner, int exit, std::vector<int>& corners) const {
	const int copy = assembly_.copyAt(corner);
	corners = {corner};
	for (int across = assembly_.across(exit); across >= 0; across = assembly_.across(exit)) {
		const bool startsHere = assembly_.copyAt(across) == copy;
		const int next = startsHere ? across : nextCorner(across);
		if (next == corner)
			return;
		corners.push_back(next);
		exit = startsHere ? previousCorner(next) : next;
	}
}

void SecondRings::orderFan(int copy) {
	const int start = assembly_.cornerStart[copy], count = assembly_.cornerStart[copy + 1] - start;
	const int first = assembly_.corners[start];
	std::vector<int> fan;
	walk(first, first, fan);
	if (!assembly_.copyInterior[copy]) { // that was a part of it: now from the end that was met
		std::vector<int> rest;
		walk(first, previousCorner(first), rest);
		std::reverse(rest.begin(), rest.end());
		rest.insert(rest.end(), fan.begin() + 1, fan.end());
		fan = std::move(rest);
	}
	for (int rank = 0; rank < count; ++rank) {
		fans_[start + rank] = fan[rank];
		rankOfCorner_[fan[rank]] = rank;
	}
}

void SecondRings::addTriangle(int corner, std::vector<int>& ring) const {
	ring.push_back(assembly_.copyAt(nextCorner(corner)));
	ring.push_back(assembly_.copyAt(previousCorner(corner)));
}

void SecondRings::addRound(int corner, std::vector<int>& ring) const {
	const int copy = assembly_.copyAt(corner);
	const int start = assembly_.cornerStart[copy], count = assembly_.cornerStart[copy + 1] - start;
	if (count <= mostTriangles) {
		for (int rank = 0; rank < count; ++rank)
			addTriangle(fans_[start + rank], ring);
		return;
	}
	const int rank = rankOfCorner_[corner];
	const bool closed = assembly_.copyInterior[copy];
	const int steps = closed ? mostTriangles / 2 : mostTriangles;
	for (int step = 0; step <= steps; ++step) {
		const int offset = static_cast<int>(std::lround(step * double(count) / mostTriangles));
		for (const int other : {rank - offset, rank + offset})
			if (closed || (other >= 0 && other < count))
				addTriangle(fans_[start + (other + count) % count], ring);
	}
}

void SecondRings::collect(int copy, std::vector<int>& ring) const {
	ring.clear();
	for (int i = assembly_.cornerStart[copy]; i < assembly_.cornerStart[copy + 1]; ++i)
		for (const int corner : {nextCorner(assembly_.corners[i]), previousCorner(assembly_.corners[i])})
			addRound(corner, ring);
	std::sort(ring.begin(), ring.end());
	ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
	ring.erase(std::find(ring.begin(), ring.end(), copy));
}

} // namespace developable::detail
