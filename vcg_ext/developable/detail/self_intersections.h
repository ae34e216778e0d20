// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.h: whether a move of the local method makes the surface cut itself (Section 7).
#pragma once

#include "box_tree.h"
#include "local_mesh.h"
#include "triangle_intersection.h"

#include <optional>

namespace developable::detail {

/// Finds the triangles that those round a moved place cut. Triangles are numbered in the order of the places
/// that they are at, which is spatial.
class SelfIntersections {
public:
	/// \param roundedToFloat  look at positions as a mesh in float holds them
	SelfIntersections(const LocalMesh& mesh, bool roundedToFloat)
		: mesh_(mesh), roundedToFloat_(roundedToFloat), triangles_(mesh.corners.size(), -1),
		  copies_(3, mesh.corners.size() / 3) {
		int count = 0;
		for (int copy = 0; copy < mesh.copyCount(); ++copy)
			for (int i = mesh.copies[copy].firstCorner; i < mesh.copies[copy + 1].firstCorner; ++i) {
				const LocalMesh::Corner& corner = mesh.corners[i];
				if (triangles_[i] < 0)
					triangles_[i] = triangles_[corner.corner[0]] = triangles_[corner.corner[1]] = count++;
				copies_(corner.number, triangles_[i]) = copy;
			}
		std::vector<Box> boxes(count);
		for (int t = 0; t < count; ++t)
			boxes[t] = boxOf(triangle(t).corners);
		tree_.emplace(std::move(boxes));
	}

	/// Takes note of a move. Whether a triangle at the place now cuts one that it did not cut at the start.
	bool newOnes(int place) {
		update(place);
		const int* own = &triangles_[mesh_.places[place].firstCorner];
		for (std::size_t i = 0; i < moved_.size(); ++i)
			for (std::size_t j = 0; j < i; ++j)
				if (intersect(moved_[i], moved_[j]) && !intersectedAtStart(own[i], own[j]))
					return true;
		for (const int other : tree_->near(around_)) {
			if (std::find(own, own + moved_.size(), other) != own + moved_.size())
				continue;
			const PlacedTriangle candidate = triangle(other);
			if (candidate.hasBeyondAnEdge(starPlaces_, star_))
				continue;
			const Box inner = core(boxOf(candidate.corners));
			for (std::size_t i = 0; i < moved_.size(); ++i)
				if (contains(boxes_[i], inner) && intersect(moved_[i], candidate) &&
					!intersectedAtStart(own[i], other))
					return true;
		}
		return false;
	}

private:
	/// Takes note of where the triangles at a place are now.
	void update(int place) {
		moved_.clear();
		boxes_.clear();
		around_ = emptyBox();
		mesh_.forEachCorner(place, [&](int corner) {
			moved_.push_back(triangle(triangles_[corner]));
			boxes_.push_back(boxOf(moved_.back().corners));
			tree_->extend(triangles_[corner], boxes_.back());
			around_ = around_.min(boxes_.back());
		});
		starPlaces_.clear();
		star_.resize(3, 3 * moved_.size());
		const auto add = [&](int copy) {
			star_.col(starPlaces_.size()) = seen(mesh_.copies[copy].position);
			starPlaces_.push_back(mesh_.copies[copy].place);
		};
		add(mesh_.places[place].firstCopy); // first: it is inside, and so on the wrong side of most planes
		mesh_.forEachNeighbour(place, add);
	}

	Eigen::Vector3d seen(const Eigen::Vector3d& position) const {
		return roundedToFloat_ ? position.cast<float>().cast<double>() : position;
	}

	PlacedTriangle triangle(int index, bool atStart = false) const {
		Eigen::Vector3i places;
		Eigen::Matrix3d corners;
		for (int corner = 0; corner < 3; ++corner) {
			const LocalMesh::Copy& copy = mesh_.copies[copies_(corner, index)];
			places[corner] = copy.place;
			corners.col(corner) = seen(atStart ? mesh_.places[copy.place].start : copy.position);
		}
		return {places, corners};
	}

	bool intersectedAtStart(int a, int b) const { return intersect(triangle(a, true), triangle(b, true)); }

	const LocalMesh& mesh_;
	bool roundedToFloat_;
	std::vector<int> triangles_;  // per corner
	Eigen::Matrix3Xi copies_;     // of the triangles
	std::optional<BoxTree> tree_; // of the triangles

	// The star of the place that moved last: its triangles with their boxes, and their corners, each once.
	std::vector<PlacedTriangle> moved_;
	std::vector<Box> boxes_;
	Box around_;
	std::vector<int> starPlaces_;
	Positions star_;
};

} // namespace developable::detail
