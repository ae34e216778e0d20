// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.h: whether a move of the local method makes the surface cut itself (Section 7).
#pragma once

#include "local_mesh.h"
#include "triangle_intersection.h"

#include <memory>
#include <vcg/space/index/grid_static_ptr.h>

namespace developable::detail {

/// The box that a triangle can't leave, with the members that vcglib's grid asks of what it holds.
class SweptTriangle {
public:
	using ScalarType = double;

	/// \param reach  how far its corners may move, length
	SweptTriangle(int index, const Eigen::AlignedBox3d& box, double reach) : index_(index) {
		const Eigen::Vector3d low = box.min().array() - reach, high = box.max().array() + reach;
		box_ = vcg::Box3d({low[0], low[1], low[2]}, {high[0], high[1], high[2]});
	}

	int index() const { return index_; }
	void GetBBox(vcg::Box3d& box) const { box = box_; }
	bool IsD() const { return false; }

private:
	int index_;
	vcg::Box3d box_;
};

/// Finds the triangles that those round a moved place cut. Heights are bounded, so every triangle stays
/// within a box and whom a place's triangles can ever meet is settled before the first move; each list is
/// made when it is first asked for.
class SelfIntersections {
public:
	/// \param reach  how far a place may move from its start, length; 0: never asked
	SelfIntersections(const LocalMesh& mesh, double reach) : mesh_(mesh) {
		if (reach == 0)
			return;
		triangles_.resize(mesh.triangles.size() / 3);
		for (int place = 0; place < mesh.placeCount(); ++place)
			mesh.forEachCorner(place, [&](int corner) {
				triangles_[mesh.triangles[corner]][mesh.corners[corner].number] = place;
			});
		for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
			boxes_.push_back(triangle(t).box);
			swept_.emplace_back(t, boxes_.back(), reach);
		}
		grid_ = std::make_unique<Grid>();
		grid_->Set(swept_.begin(), swept_.end());
		marks_.assign(triangles_.size(), -1);
		candidates_.resize(mesh.placeCount());
	}

	/// Takes note of a move. Whether a triangle at the place now cuts one that it did not cut at the start.
	bool newOnes(int place) {
		update(place);
		Eigen::AlignedBox3d around;
		moved_.clear();
		mesh_.forEachCorner(place, [&](int corner) {
			moved_.push_back(triangle(mesh_.triangles[corner]));
			around.extend(moved_.back().box);
		});
		for (const int other : candidates(place)) {
			if (!around.intersects(boxes_[other]))
				continue;
			const PlacedTriangle candidate = triangle(other);
			for (int i = 0; i < static_cast<int>(moved_.size()); ++i)
				if (intersect(moved_[i], candidate) &&
					!intersectedAtStart(mesh_.triangles[mesh_.places[place].firstCorner + i], other))
					return true;
		}
		return false;
	}

	/// Takes note of a move.
	void update(int place) {
		mesh_.forEachCorner(place, [&](int corner) {
			boxes_[mesh_.triangles[corner]] = triangle(mesh_.triangles[corner]).box;
		});
	}

private:
	using Grid = vcg::GridStaticPtr<SweptTriangle, double>;

	/// Against finding an object twice in the cells that it shares: the last place that found it.
	struct Marker {
		std::vector<int>& marks;
		int place;
		void UnMarkAll() {}
		bool IsMarked(const SweptTriangle* object) const { return marks[object->index()] == place; }
		void Mark(const SweptTriangle* object) { marks[object->index()] = place; }
	};

	Eigen::Vector3i placesOf(int index) const { return triangles_[index]; }

	PlacedTriangle triangle(int index) const {
		const Eigen::Vector3i places = placesOf(index);
		Eigen::Matrix3d corners;
		for (int corner = 0; corner < 3; ++corner)
			corners.col(corner) = mesh_.position(places[corner]);
		return {places, corners};
	}

	PlacedTriangle triangleAtStart(int index) const {
		const Eigen::Vector3i places = placesOf(index);
		Eigen::Matrix3d corners;
		for (int corner = 0; corner < 3; ++corner)
			corners.col(corner) = mesh_.places[places[corner]].start;
		return {places, corners};
	}

	bool intersectedAtStart(int a, int b) const { return intersect(triangleAtStart(a), triangleAtStart(b)); }

	const std::vector<int>& candidates(int place) {
		std::vector<int>& list = candidates_[place];
		if (!list.empty())
			return list;
		Marker marker{marks_, place};
		std::vector<SweptTriangle*> near;
		for (int corner = mesh_.places[place].firstCorner; corner < mesh_.places[place + 1].firstCorner;
			 ++corner) {
			vcg::Box3d box;
			swept_[mesh_.triangles[corner]].GetBBox(box);
			grid_->GetInBox(marker, box, near);
			for (const SweptTriangle* other : near)
				list.push_back(other->index());
		}
		std::sort(list.begin(), list.end());
		return list;
	}

	const LocalMesh& mesh_;
	std::vector<Eigen::Vector3i> triangles_;
	std::vector<Eigen::AlignedBox3d> boxes_; // of the triangles as they are now
	std::vector<SweptTriangle> swept_;
	std::unique_ptr<Grid> grid_;
	std::vector<PlacedTriangle> moved_; // scratch
	std::vector<int> marks_;
	std::vector<std::vector<int>>
		candidates_; // per place; never empty once made, for it holds its own triangles
};

} // namespace developable::detail
