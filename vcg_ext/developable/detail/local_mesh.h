// SPDX-License-Identifier: GPL-3.0-or-later
// local_mesh.h: the assembly as the local method reads it: what one visit needs lies together.
#pragma once

#include "../angle_defect.h"
#include "../local_method_options.h"
#include "spatial_order.h"
#include "vertex_normals.h"

#include <unordered_map>

namespace developable::detail {

/// The worst vertex may be anywhere, and on a large mesh fetching what a visit needs takes longer than the
/// visit. So places are renumbered in spatial order, copies in the order of their places and corners in that
/// of their copies. The corners of a copy keep their order among each other, and with it every sum its last
/// bit.
struct LocalMesh {
	/// A place on the line along its original normal. What the next one begins with ends its own.
	struct alignas(64) Place {
		Eigen::Vector3d start = Eigen::Vector3d::Zero();
		Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< the average over all copies, unit
		double height = 0;                                ///< how far it is along the normal
		int firstCopy = 0, firstCorner = 0;
	};

	struct Copy {
		Eigen::Vector3d position;
		double defect = 0;
		int place = 0, firstCorner = 0;
		bool interior = false; ///< inside its patch
		bool movable = false;  ///< its place may move
		bool alone = false;    ///< its place has no other
		bool watched = false;  ///< T of movable places with several copies has a term for it
	};

	/// A corner of a triangle, and the triangle's other two, counted from here.
	struct Corner {
		int copy[2];        ///< the two others'
		int corner[2];      ///< which the two others are
		signed char number; ///< of this one in its triangle, 0 to 2
		bool isNew[2];      ///< no corner before, of this place, has that copy
	};

	std::vector<int> originalPlace, originalCopy; ///< per place and per copy, its number in the assembly
	std::vector<Place> places;                    ///< one more at the end
	std::vector<Copy> copies;                     ///< one more at the end
	std::vector<Corner> corners;
	std::vector<double> cotangents;                     ///< per corner
	std::unordered_map<int, std::vector<int>> watchers; ///< per watched copy, those places

	LocalMesh(const PatchAssembly& assembly, const Positions& original, AssemblingVertices assemblingVertices)
		: originalPlace(spatialOrder(original)) {
		fillPlaces(assembly, original);
		fillCopies(assembly, assemblingVertices);
		fillCorners(assembly, cornerCotangents(assembly, original));
		findNeighbours();
	}

	int placeCount() const { return static_cast<int>(originalPlace.size()); }
	int copyCount() const { return static_cast<int>(originalCopy.size()); }
	int ownCopies(int place) const { return places[place + 1].firstCopy - places[place].firstCopy; }
	bool movable(int place) const { return copies[places[place].firstCopy].movable; }
	const Eigen::Vector3d& position(int place) const { return copies[places[place].firstCopy].position; }

	/// Calls a function with each copy of a place.
	template <class Function>
	void forEachOwn(int place, const Function& function) const {
		for (int copy = places[place].firstCopy; copy < places[place + 1].firstCopy; ++copy)
			function(copy);
	}

	/// Calls a function with each corner at a place.
	template <class Function>
	void forEachCorner(int place, const Function& function) const {
		for (int corner = places[place].firstCorner; corner < places[place + 1].firstCorner; ++corner)
			function(corner);
	}

	/// Calls a function with each copy next to those of a place, once.
	template <class Function>
	void forEachNeighbour(int place, const Function& function) const {
		forEachCorner(place, [&](int corner) {
			for (int other = 0; other < 2; ++other)
				if (corners[corner].isNew[other])
					function(corners[corner].copy[other]);
		});
	}

	/// Calls a function with each copy that T of a place has a term for.
	template <class Function>
	void forEachAffected(int place, const Function& function) const {
		forEachOwn(place, function);
		forEachNeighbour(place, function);
	}

private:
	/// Patches may be oriented differently: a copy's normal counts with the sign that suits the first copy.
	void fillPlaces(const PatchAssembly& assembly, const Positions& original) {
		std::vector<int> placeAt(assembly.placeCount());
		for (int place = 0; place < placeCount(); ++place)
			placeAt[originalPlace[place]] = place;
		places.resize(placeCount() + 1);
		for (const int originalOne : assembly.placeOfCopy)
			++places[placeAt[originalOne] + 1].firstCopy;
		for (int place = 0; place < placeCount(); ++place) {
			places[place].start = original.col(originalPlace[place]);
			places[place + 1].firstCopy += places[place].firstCopy;
		}
		originalCopy.resize(assembly.copyCount());
		std::vector<int> found(placeCount(), 0);
		const Eigen::Matrix3Xd normals = copyNormals(assembly, original);
		for (int copy = 0; copy < assembly.copyCount(); ++copy) {
			const int at = placeAt[assembly.placeOfCopy[copy]];
			originalCopy[places[at].firstCopy + found[at]++] = copy;
			places[at].normal += normals.col(copy) * (places[at].normal.dot(normals.col(copy)) < 0 ? -1 : 1);
		}
		for (int place = 0; place < placeCount(); ++place)
			if (ownCopies(place) > 1 && !places[place].normal.isZero(1e-9))
				places[place].normal.normalize();
	}

	/// Movable is what lies inside a patch, or where patches meet if that may move too; a free edge of the
	/// object stays.
	void fillCopies(const PatchAssembly& assembly, AssemblingVertices assemblingVertices) {
		for (int place = 0; place < placeCount(); ++place) {
			const int originalOne = originalPlace[place];
			const bool assembling = assembly.placeAssembling[originalOne];
			const bool mayMove = !assembly.placeFixed[originalOne] && !places[place].normal.isZero(1e-9) &&
								 (!assembling || assemblingVertices == AssemblingVertices::MoveTogether);
			for (int copy = places[place].firstCopy; copy < places[place + 1].firstCopy; ++copy) {
				const bool interior = assembly.copyInterior[originalCopy[copy]];
				copies.push_back({places[place].start, 0, place, 0, interior,
								  mayMove && (interior || assembling), ownCopies(place) == 1, false});
			}
		}
		copies.emplace_back();
	}

	void fillCorners(const PatchAssembly& assembly, const Eigen::Matrix3Xd& originalCotangents) {
		std::vector<int> copyAt(copyCount()), cornerAt(assembly.corners.size()); // by the assembly's numbers
		for (int copy = 0, next = 0; copy < copyCount(); ++copy) {
			const int originalOne = originalCopy[copy];
			copyAt[originalOne] = copy;
			copies[copy].firstCorner = next;
			for (int i = assembly.cornerStart[originalOne]; i < assembly.cornerStart[originalOne + 1]; ++i)
				cornerAt[assembly.corners[i]] = next++;
		}
		copies.back().firstCorner = static_cast<int>(cornerAt.size());
		for (Place& place : places)
			place.firstCorner = copies[place.firstCopy].firstCorner;
		corners.resize(cornerAt.size());
		cotangents.resize(cornerAt.size());
		for (int i = 0; i < static_cast<int>(cornerAt.size()); ++i) {
			Corner& corner = corners[cornerAt[i]];
			corner.number = static_cast<signed char>(i % 3);
			for (const int other : {0, 1}) {
				const int number = (i % 3 + 1 + other) % 3;
				corner.copy[other] = copyAt[assembly.triangleCopies(number, i / 3)];
				corner.corner[other] = cornerAt[i - i % 3 + number];
			}
			cotangents[cornerAt[i]] = originalCotangents.data()[i];
		}
	}

	void findNeighbours() {
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
};

} // namespace developable::detail
