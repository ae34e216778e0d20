// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.h: whether a move of the local method makes the surface cut itself (Section 7).
#pragma once

#include "movers.h"
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
	SelfIntersections(const PatchAssembly& assembly, const Positions& start, double reach)
		: assembly_(assembly), start_(start) {
		if (reach == 0)
			return;
		for (int t = 0; t < assembly.triangleCount(); ++t) {
			boxes_.push_back(triangle(t, start).box);
			swept_.emplace_back(t, boxes_.back(), reach);
		}
		grid_ = std::make_unique<Grid>();
		grid_->Set(swept_.begin(), swept_.end());
		marks_.assign(assembly.triangleCount(), -1);
		candidates_.resize(assembly.placeCount());
	}

	/// Takes note of a move. Whether a triangle at the place now cuts one that it did not cut at the start.
	bool newOnes(const Movers& movers, int place, const Positions& positions) {
		update(movers, place, positions);
		Eigen::AlignedBox3d around;
		moved_.clear();
		for (const int corner : movers.corners.of(place)) {
			moved_.push_back(triangle(corner / 3, positions));
			around.extend(moved_.back().box);
		}
		for (const int other : candidates(movers, place)) {
			if (!around.intersects(boxes_[other]))
				continue;
			const PlacedTriangle candidate = triangle(other, positions);
			for (int i = 0; i < static_cast<int>(moved_.size()); ++i)
				if (intersect(moved_[i], candidate) &&
					!intersectedAtStart(movers.corners.of(place).first[i] / 3, other))
					return true;
		}
		return false;
	}

	/// Takes note of a move.
	void update(const Movers& movers, int place, const Positions& positions) {
		for (const int corner : movers.corners.of(place))
			boxes_[corner / 3] = triangle(corner / 3, positions).box;
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

	PlacedTriangle triangle(int index, const Positions& positions) const {
		return {assembly_.trianglePlaces.col(index), positions};
	}

	bool intersectedAtStart(int a, int b) const {
		return intersect(triangle(a, start_), triangle(b, start_));
	}

	const std::vector<int>& candidates(const Movers& movers, int place) {
		std::vector<int>& list = candidates_[place];
		if (!list.empty())
			return list;
		Marker marker{marks_, place};
		std::vector<SweptTriangle*> near;
		for (const int corner : movers.corners.of(place)) {
			vcg::Box3d box;
			swept_[corner / 3].GetBBox(box);
			grid_->GetInBox(marker, box, near);
			for (const SweptTriangle* other : near)
				list.push_back(other->index());
		}
		std::sort(list.begin(), list.end());
		return list;
	}

	const PatchAssembly& assembly_;
	const Positions start_;
	std::vector<Eigen::AlignedBox3d> boxes_; // of the triangles as they are now
	std::vector<SweptTriangle> swept_;
	std::unique_ptr<Grid> grid_;
	std::vector<PlacedTriangle> moved_; // scratch
	std::vector<int> marks_;
	std::vector<std::vector<int>>
		candidates_; // per place; never empty once made, for it holds its own triangles
};

} // namespace developable::detail
