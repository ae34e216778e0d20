// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.h: whether a move of the local method makes the surface cut itself (Section 7).
#pragma once

#include "local_mesh.h"
#include "triangle_intersection.h"

#include <unsupported/Eigen/BVH>

namespace developable::detail {

/// Finds the triangles that those round a moved place cut. Heights are bounded, so whom a place's triangles
/// can ever meet is settled before the first move; each list is made when it is first asked for.
class SelfIntersections {
public:
	/// \param reach  how far a place may move from its start, length; 0: never asked
	SelfIntersections(const LocalMesh& mesh, double reach) : mesh_(mesh) {
		if (reach == 0)
			return;
		copies_.resize(3, mesh.triangles.size() / 3);
		for (int copy = 0; copy < mesh.copyCount(); ++copy)
			for (int i = mesh.copies[copy].firstCorner; i < mesh.copies[copy + 1].firstCorner; ++i)
				copies_(mesh.corners[i].number, mesh.triangles[i]) = copy;
		std::vector<int> numbers;
		for (int t = 0; t < copies_.cols(); ++t) {
			numbers.push_back(t);
			boxes_.push_back(triangle(t).box);
			swept_.push_back(sweptBox(t, reach));
		}
		tree_.init(numbers.begin(), numbers.end(), swept_.begin(), swept_.end());
		candidates_.resize(mesh.placeCount());
	}

	/// Takes note of a move. Whether a triangle at the place now cuts one that it did not cut at the start.
	bool newOnes(int place) {
		update(place);
		Eigen::AlignedBox3d around;
		for (const PlacedTriangle& triangle : moved_)
			around.extend(triangle.box);
		const int* own = &mesh_.triangles[mesh_.places[place].firstCorner];
		for (std::size_t i = 0; i < moved_.size(); ++i)
			for (std::size_t j = 0; j < i; ++j)
				if (intersect(moved_[i], moved_[j]) && !intersectedAtStart(own[i], own[j]))
					return true;
		for (const int other : candidates(place)) {
			if (!around.intersects(boxes_[other]))
				continue;
			const PlacedTriangle candidate = triangle(other);
			for (std::size_t i = 0; i < moved_.size(); ++i)
				if (intersect(moved_[i], candidate) && !intersectedAtStart(own[i], other))
					return true;
		}
		return false;
	}

	/// Takes note of a move.
	void update(int place) {
		moved_.clear();
		mesh_.forEachCorner(place, [&](int corner) {
			moved_.push_back(triangle(mesh_.triangles[corner]));
			boxes_[mesh_.triangles[corner]] = moved_.back().box;
		});
	}

private:
	PlacedTriangle triangle(int index, bool atStart = false) const {
		Eigen::Vector3i places;
		Eigen::Matrix3d corners;
		for (int corner = 0; corner < 3; ++corner) {
			const LocalMesh::Copy& copy = mesh_.copies[copies_(corner, index)];
			places[corner] = copy.place;
			corners.col(corner) = atStart ? mesh_.places[copy.place].start : copy.position;
		}
		return {places, corners};
	}

	/// The box that a triangle cannot leave, for its corners move along their normals and not far.
	Eigen::AlignedBox3d sweptBox(int index, double mostReach) const {
		Eigen::AlignedBox3d box;
		for (const int copy : copies_.col(index)) {
			const LocalMesh::Place& place = mesh_.places[mesh_.copies[copy].place];
			const double reach = mesh_.copies[copy].movable ? mostReach : 0;
			box.extend(place.start - reach * place.normal);
			box.extend(place.start + reach * place.normal);
		}
		return box;
	}

	bool intersectedAtStart(int a, int b) const { return intersect(triangle(a, true), triangle(b, true)); }

	/// What Eigen's search in a tree of boxes asks: collects the triangles that come near a box.
	struct Collector {
		const SelfIntersections& all;
		const Eigen::AlignedBox3d& near;
		std::vector<int>& found;

		bool intersectVolume(const Eigen::AlignedBox3d& box) const { return near.intersects(box); }
		bool intersectObject(int triangle) const {
			if (near.intersects(all.swept_[triangle]))
				found.push_back(triangle);
			return false; // go on
		}
	};

	/// The triangles that those at a place may ever meet, without its own.
	const std::vector<int>& candidates(int place) {
		std::vector<int>& list = candidates_[place];
		if (!list.empty())
			return list;
		Eigen::AlignedBox3d near;
		mesh_.forEachCorner(place, [&](int i) { near.extend(swept_[mesh_.triangles[i]]); });
		found_.clear();
		Collector collector{*this, near, found_};
		Eigen::BVIntersect(tree_, collector);
		mesh_.forEachCorner(place, [&](int i) {
			found_.erase(std::remove(found_.begin(), found_.end(), mesh_.triangles[i]), found_.end());
		});
		list = found_;
		return list;
	}

	const LocalMesh& mesh_;
	Eigen::Matrix3Xi copies_;                  // of the triangles
	std::vector<Eigen::AlignedBox3d> boxes_;   // of the triangles as they are now
	std::vector<Eigen::AlignedBox3d> swept_;   // what they cannot leave
	Eigen::KdBVH<double, 3, int> tree_;        // of those
	std::vector<std::vector<int>> candidates_; // per place, made when first asked for
	std::vector<PlacedTriangle> moved_;        // those at the place that moved last
	std::vector<int> found_;                   // scratch
};

} // namespace developable::detail
