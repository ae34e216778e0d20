// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.cpp: the triangles that those round a moved place cut.
#include "self_intersections.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

SelfIntersections::SelfIntersections(const LocalMesh& mesh, bool roundedToFloat)
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

bool SelfIntersections::newOnes(int place) {
	update(place);
	const int* own = &triangles_[mesh_.places[place].firstCorner];
	for (std::size_t i = 0; i < moved_.size(); ++i)
		for (std::size_t j = 0; j < i; ++j)
			if (intersect(moved_[i], moved_[j]) && !intersectedAtStart(own[i], own[j]))
				return true;
	for (const int other : tree_->near(around_))
		if (starIsCutBy(other, own))
			return true;
	return false;
}

/// Whether a triangle cuts one of the star's, without being one, that it did not cut at the start.
/// \param own  the star's triangles, in the order of moved_
bool SelfIntersections::starIsCutBy(int other, const int* own) const {
	if (std::find(own, own + moved_.size(), other) != own + moved_.size())
		return false;
	const PlacedTriangle candidate = triangle(other);
	if (candidate.hasBeyondAnEdge(starPlaces_, star_))
		return false;
	const Box inner = core(boxOf(candidate.corners));
	for (std::size_t i = 0; i < moved_.size(); ++i)
		if (contains(boxes_[i], inner) && intersect(moved_[i], candidate) &&
			!intersectedAtStart(own[i], other))
			return true;
	return false;
}

/// Takes note of where the triangles at a place are now.
void SelfIntersections::update(int place) {
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
	star_ = Eigen::Matrix3Xd(3, 3 * moved_.size()); // to resize it would leave it broken for want of memory
	const auto add = [&](int copy) {
		star_.col(starPlaces_.size()) = seen(mesh_.copies[copy].position);
		starPlaces_.push_back(mesh_.copies[copy].place);
	};
	add(mesh_.places[place].firstCopy); // first: it is inside, and so on the wrong side of most planes
	mesh_.forEachNeighbour(place, add);
}

Eigen::Vector3d SelfIntersections::seen(const Eigen::Vector3d& position) const {
	return roundedToFloat_ ? position.cast<float>().cast<double>() : position;
}

PlacedTriangle SelfIntersections::triangle(int index, bool atStart) const {
	Eigen::Vector3i places;
	Eigen::Matrix3d corners;
	for (int corner = 0; corner < 3; ++corner) {
		const LocalMesh::Copy& copy = mesh_.copies[copies_(corner, index)];
		places[corner] = copy.place;
		corners.col(corner) = seen(atStart ? mesh_.places[copy.place].start : copy.position);
	}
	return {places, corners};
}

bool SelfIntersections::intersectedAtStart(int a, int b) const {
	return intersect(triangle(a, true), triangle(b, true));
}

} // namespace developable::detail
