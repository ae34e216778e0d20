// SPDX-License-Identifier: GPL-3.0-or-later
// self_intersections.h: whether a move of the local method makes the surface cut itself (Section 7).
#pragma once

#include "developable/geometry/geometry.h"
#include "local_mesh.h"

#include <optional>
#include <vector>

namespace developable::detail {

/// Finds the triangles that those round a moved place cut. Triangles are numbered in the order of the places
/// that they are at, which is spatial.
class SelfIntersections {
public:
	/// \param roundedToFloat  look at positions as a mesh in float holds them
	SelfIntersections(const LocalMesh& mesh, bool roundedToFloat);

	/// Takes note of a move. Whether a triangle at the place now cuts one that it did not cut at the start.
	bool newOnes(int place);

private:
	void update(int place);
	bool starIsCutBy(int other, const int* own) const;
	Eigen::Vector3d seen(const Eigen::Vector3d& position) const;
	PlacedTriangle triangle(int index, bool atStart = false) const;
	bool intersectedAtStart(int a, int b) const;

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
