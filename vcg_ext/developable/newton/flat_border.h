// SPDX-License-Identifier: GPL-3.0-or-later
// flat_border.h: where a patch's border lies in the plane once the patch is flat.
#pragma once

#include "developable/mesh/mesh.h"

#include <array>
#include <vector>

namespace developable::detail {

/// The border of each patch that is a disk, as half edges one after the other; none of another patch, nor of
/// one whose triangles do not all run round alike.
std::vector<std::vector<int>> bordersOfDisks(const PatchAssembly& assembly);

/// Half edges of a border, one after the other, in the plane: they are as long as they are, and turn by what
/// their patch's angles leave of π. The patch is to their left.
class FlatBorder {
public:
	/// \param angles  of all copies, see borderAngles
	FlatBorder(const PatchAssembly& assembly, const Positions& positions, const Eigen::VectorXd& angles,
			   const std::vector<int>& halfEdges);

	/// Where each begins, and where the last one ends, length.
	const std::vector<Eigen::Vector2d>& points() const { return points_; }
	/// In which each runs, one long.
	const Eigen::Vector2d& direction(int edge) const { return directions_[edge]; }
	/// From each point to the next along the border, length.
	double length(int edge) const { return (points_[edge + 1] - points_[edge]).norm(); }

	/// How far a point is to the right of the line through an edge, length: less than 0 where it lies on the
	/// edge's own patch.
	double gap(int edge, int point) const { return rightOf(edge).dot(points_[point] - points_[edge]); }
	/// The unit vector at right angles to an edge, away from the patch.
	Eigen::Vector2d rightOf(int edge) const { return {directions_[edge][1], -directions_[edge][0]}; }

	/// Of a whole border where each begins, 2 x half edges.
	Eigen::Matrix2Xd closed() const;

private:
	std::vector<Eigen::Vector2d> points_, directions_;
};

/// Pairs of a closed border's edges that cross, by their place in it.
/// \param border  2 x points, one after the other
std::vector<std::array<int, 2>> crossingsOf(const Eigen::Matrix2Xd& border);

/// A point of a border that is to be to the right of one of its edges.
struct BorderGap {
	std::vector<int> halfEdges; ///< of the border, from the edge to the point or from there to the edge
	int edge = 0, point = 0;    ///< among these, and among their ends
	double wanted = 0;          ///< how far to the right the point is to be, length
};

/// The gradient of such a gap with respect to the places, 3 x places; 0 at those that are held still. It
/// follows from those of the lengths and angles between: where a border turns by more at a point, all behind
/// it turns about that.
/// \param border  the gap's half edges, laid flat
Positions gapGradient(const PatchAssembly& assembly, const Positions& positions, const BorderGap& gap,
					  const FlatBorder& border);

} // namespace developable::detail
