// SPDX-License-Identifier: GPL-3.0-or-later
// local_mesh.h: the assembly as the local method reads it: what one visit needs lies together.
#pragma once

#include "local_method.h"

#include <unordered_map>
#include <vector>

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
		int copy[2];        ///< the two others': the next one's, the previous one's
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

	LocalMesh(const PatchAssembly& assembly, const Positions& original,
			  AssemblingVertices assemblingVertices);

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
	void fillPlaces(const PatchAssembly& assembly, const Positions& original);
	void fillNormals(const PatchAssembly& assembly, const Positions& original);
	void fillCopies(const PatchAssembly& assembly, AssemblingVertices assemblingVertices);
	void fillCorners(const PatchAssembly& assembly, const Eigen::Matrix3Xd& originalCotangents);
	void findNeighbours();
};

} // namespace developable::detail
