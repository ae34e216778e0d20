// SPDX-License-Identifier: GPL-3.0-or-later
// local_mesh.cpp: an assembly renumbered for the local method.
#include "local_mesh.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

LocalMesh::LocalMesh(const PatchAssembly& assembly, const Positions& original,
					 AssemblingVertices assemblingVertices)
	: originalPlace(spatialOrder(original)) {
	fillPlaces(assembly, original);
	fillNormals(assembly, original);
	fillCopies(assembly, assemblingVertices);
	fillCorners(assembly, cornerCotangents(assembly, original));
	findNeighbours();
}

void LocalMesh::fillPlaces(const PatchAssembly& assembly, const Positions& original) {
	std::vector<int> newPlace(assembly.placeCount()); // by the assembly's number
	for (int place = 0; place < placeCount(); ++place)
		newPlace[originalPlace[place]] = place;
	Groups copiesOfPlaces = grouped(placeCount(), assembly.copyCount(),
									[&](int copy) { return newPlace[assembly.placeOfCopy[copy]]; });
	places.resize(placeCount() + 1);
	for (int place = 0; place < placeCount(); ++place) {
		places[place].start = original.col(originalPlace[place]);
		places[place + 1].firstCopy = copiesOfPlaces.start[place + 1];
	}
	originalCopy = std::move(copiesOfPlaces.members);
}

/// Patches may be oriented differently: a copy's normal counts with the sign that suits the first copy.
void LocalMesh::fillNormals(const PatchAssembly& assembly, const Positions& original) {
	const Eigen::Matrix3Xd normals = copyNormals(assembly, original);
	for (int place = 0; place < placeCount(); ++place) {
		Eigen::Vector3d& sum = places[place].normal;
		forEachOwn(place, [&](int copy) {
			const auto normal = normals.col(originalCopy[copy]);
			sum += normal * (sum.dot(normal) < 0 ? -1 : 1);
		});
		if (ownCopies(place) > 1 && !sum.isZero(1e-9))
			sum.normalize();
	}
}

/// Movable is what lies inside a patch, or where patches meet if that may move too; a free edge of the object
/// stays.
void LocalMesh::fillCopies(const PatchAssembly& assembly, AssemblingVertices assemblingVertices) {
	for (int place = 0; place < placeCount(); ++place) {
		const int originalOne = originalPlace[place];
		const bool assembling = assembly.placeAssembling[originalOne];
		const bool mayMove = !assembly.placeFixed[originalOne] && !places[place].normal.isZero(1e-9) &&
							 (!assembling || assemblingVertices == AssemblingVertices::MoveTogether);
		forEachOwn(place, [&](int copy) {
			const bool interior = assembly.copyInterior[originalCopy[copy]];
			copies.push_back({places[place].start, 0, place, 0, interior, mayMove && (interior || assembling),
							  ownCopies(place) == 1, false});
		});
	}
	copies.emplace_back();
}

void LocalMesh::fillCorners(const PatchAssembly& assembly, const Eigen::Matrix3Xd& originalCotangents) {
	std::vector<int> newCopy(copyCount()), newCorner(assembly.corners.size()); // by the assembly's numbers
	for (int copy = 0, next = 0; copy < copyCount(); ++copy) {
		const int originalOne = originalCopy[copy];
		newCopy[originalOne] = copy;
		copies[copy].firstCorner = next;
		for (int i = assembly.cornerStart[originalOne]; i < assembly.cornerStart[originalOne + 1]; ++i)
			newCorner[assembly.corners[i]] = next++;
	}
	copies.back().firstCorner = static_cast<int>(newCorner.size());
	for (Place& place : places)
		place.firstCorner = copies[place.firstCopy].firstCorner;
	corners.resize(newCorner.size());
	cotangents.resize(newCorner.size());
	for (int original = 0; original < static_cast<int>(newCorner.size()); ++original) {
		Corner& corner = corners[newCorner[original]];
		corner.number = static_cast<signed char>(cornerInTriangle(original));
		const int others[] = {nextCorner(original), previousCorner(original)};
		for (const int other : {0, 1}) {
			corner.copy[other] = newCopy[assembly.copyAt(others[other])];
			corner.corner[other] = newCorner[others[other]];
		}
		cotangents[newCorner[original]] = originalCotangents.data()[original];
	}
}

void LocalMesh::findNeighbours() {
	for (int place = 0; place < placeCount(); ++place) {
		if (!movable(place))
			continue;
		std::vector<int> known;
		forEachCorner(place, [&](int corner) {
			for (const int other : {0, 1}) {
				const int copy = corners[corner].copy[other];
				corners[corner].isNew[other] = std::find(known.begin(), known.end(), copy) == known.end();
				known.push_back(copy);
			}
		});
		if (ownCopies(place) > 1)
			forEachAffected(place, [&](int copy) {
				copies[copy].watched = true;
				watchers[copy].push_back(place);
			});
	}
}

} // namespace developable::detail
