// SPDX-License-Identifier: GPL-3.0-or-later
// unfolded_hinges.h: a triangle with those round it, unfolded into its plane.
#pragma once

#include "developable/mesh/mesh.h"

#include <array>
#include <vector>

namespace developable::detail {

/// Two triangles with a common edge, laid into a plane.
struct UnfoldedHinge {
	std::array<int, 4> points; ///< the edge's ends, then the two corners opposite to it
	Eigen::Vector4d jump;      ///< K_e, per point: the jump of the slope across the edge times its length
	Eigen::Matrix2d response;  ///< C_e: K_e f = ⟨C_e, f''⟩ for a quadratic f
	double area;               ///< of both triangles
};

/// A triangle, its neighbours and so on, unfolded one over the edge of the other; a triangle that is reached
/// in two ways is there twice.
class UnfoldedHinges {
public:
	UnfoldedHinges(const PatchAssembly& assembly, const Eigen::VectorXd& areas, int triangle);

	/// Adds the neighbours of the triangles that were added last. \return whether there were any
	bool widen();

	const std::vector<UnfoldedHinge>& hinges() const { return hinges_; }
	const std::vector<int>& places() const { return places_; } ///< of the points
	const std::vector<Eigen::Vector2d>& points() const {
		return points_;
	} ///< the triangle's own are the first

private:
	struct Sheet {
		int triangle;
		std::array<int, 3> points;
		int entry; ///< the half edge that it was reached over, or -1
	};

	void unfold(const Sheet& sheet, int halfEdge, int across);
	Eigen::Vector3d positionOf(int corner) const {
		return assembly_.originalPositions.col(assembly_.placeAt(corner));
	}

	const PatchAssembly& assembly_;
	const Eigen::VectorXd& areas_;
	std::vector<Sheet> outermost_, next_;
	std::vector<int> places_;
	std::vector<Eigen::Vector2d> points_;
	std::vector<UnfoldedHinge> hinges_;
};

} // namespace developable::detail
