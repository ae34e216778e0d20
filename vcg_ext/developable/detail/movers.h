// SPDX-License-Identifier: GPL-3.0-or-later
// movers.h: the places that the local method may move, and what each move touches.
#pragma once

#include "../local_method_options.h"
#include "lists.h"
#include "vertex_normals.h"

namespace developable::detail {

/// The places that may move (Section 5.2.3), each along its original normal.
struct Movers {
	std::vector<char> movable; ///< per place
	Eigen::Matrix3Xd normals;  ///< 3 x places, unit; the average over all copies
	Lists corners;             ///< per movable place, the corners that lie at it
	Lists affected;            ///< per movable place, the copies in T: its own first, then their neighbours
	std::vector<int> own;      ///< per place, how many of `affected` are its own
	Lists watchers;            ///< per copy, the movable assembling places that have it as a neighbour

	Movers(const PatchAssembly& assembly, const Positions& positions, AssemblingVertices assemblingVertices)
		: normals(placeNormals(assembly, positions)) {
		findMovable(assembly, assemblingVertices);
		fillLists(assembly);
		fillWatchers(assembly);
	}

private:
	/// Patches may be oriented differently: a copy's normal counts with the sign that suits the first copy.
	static Eigen::Matrix3Xd placeNormals(const PatchAssembly& assembly, const Positions& positions) {
		const Eigen::Matrix3Xd copies = copyNormals(assembly, positions);
		Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, assembly.placeCount());
		std::vector<int> count(assembly.placeCount(), 0);
		for (int copy = 0; copy < assembly.copyCount(); ++copy) {
			auto normal = places.col(assembly.placeOfCopy[copy]);
			normal += copies.col(copy) * (normal.dot(copies.col(copy)) < 0 ? -1 : 1);
			++count[assembly.placeOfCopy[copy]];
		}
		for (int place = 0; place < assembly.placeCount(); ++place)
			if (count[place] > 1 && !places.col(place).isZero(1e-9))
				places.col(place).normalize();
		return places;
	}

	/// Inside a patch, or where patches meet if those may move too; a free edge of the object stays.
	void findMovable(const PatchAssembly& assembly, AssemblingVertices assemblingVertices) {
		movable.resize(assembly.placeCount());
		for (int place = 0; place < assembly.placeCount(); ++place)
			movable[place] =
				!assembly.placeFixed[place] && !normals.col(place).isZero(1e-9) &&
				(!assembly.placeAssembling[place] || assemblingVertices == AssemblingVertices::MoveTogether);
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			if (!assembly.copyInterior[copy] && !assembly.placeAssembling[assembly.placeOfCopy[copy]])
				movable[assembly.placeOfCopy[copy]] = 0;
	}

	void fillLists(const PatchAssembly& assembly) {
		Lists copiesAt = listCopies(assembly);
		own.resize(assembly.placeCount());
		for (int place = 0; place < assembly.placeCount(); ++place) {
			corners.begin();
			affected.begin();
			const ListRange copies = copiesAt.of(place);
			own[place] = copies.size();
			if (!movable[place])
				continue;
			for (const int copy : copies) {
				affected.add(copy);
				for (int i = assembly.cornerStart[copy]; i < assembly.cornerStart[copy + 1]; ++i)
					corners.add(assembly.corners[i]);
			}
			for (const int copy : copies)
				for (int i = assembly.cornerStart[copy]; i < assembly.cornerStart[copy + 1]; ++i) {
					const int triangle = assembly.corners[i] / 3, corner = assembly.corners[i] % 3;
					affected.addOnce(assembly.triangleCopies((corner + 1) % 3, triangle));
					affected.addOnce(assembly.triangleCopies((corner + 2) % 3, triangle));
				}
		}
		corners.begin();
		affected.begin();
	}

	static Lists listCopies(const PatchAssembly& assembly) {
		std::vector<std::vector<int>> copiesAt(assembly.placeCount());
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			copiesAt[assembly.placeOfCopy[copy]].push_back(copy);
		Lists lists;
		for (const auto& copies : copiesAt) {
			lists.begin();
			for (const int copy : copies)
				lists.add(copy);
		}
		lists.begin();
		return lists;
	}

	void fillWatchers(const PatchAssembly& assembly) {
		std::vector<std::vector<int>> watching(assembly.copyCount());
		for (int place = 0; place < assembly.placeCount(); ++place)
			if (movable[place] && own[place] > 1)
				for (const int copy : affected.of(place))
					watching[copy].push_back(place);
		for (const auto& places : watching) {
			watchers.begin();
			for (const int place : places)
				watchers.add(place);
		}
		watchers.begin();
	}
};

} // namespace developable::detail
