// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_bound.h: what it costs to move places farther than they may go.
#pragma once

#include "developable/material/material.h"
#include "developable/mesh/mesh.h"

namespace developable::detail {

/// Σ m p(|d| / r − 1) over the places, with the displacement d of a place from the original, its share m of
/// the area, and a radius r just below what is allowed. Convex.
class DisplacementBound {
public:
	/// \param farthest  how far places may go, length; positive
	DisplacementBound(const PatchAssembly& assembly, double farthest);

	double value(const RoundedPenalty& edge, const Positions& shape) const;

	/// Of one place: 0 where it has not moved.
	Eigen::Vector3d gradient(const RoundedPenalty& edge, const Positions& shape, int place) const;
	Eigen::Matrix3d hessian(const RoundedPenalty& edge, const Positions& shape, int place) const;

	/// A shape with those places brought back that are beyond the bound, not by a bit.
	Positions within(const Positions& shape) const;

private:
	double excess(const Eigen::Vector3d& displacement) const { return displacement.norm() / radius_ - 1; }
	Eigen::Vector3d displacement(const Positions& shape, int place) const {
		return shape.col(place) - assembly_.originalPositions.col(place);
	}

	const PatchAssembly& assembly_;
	const double farthest_, radius_;
	Eigen::VectorXd masses_;
};

} // namespace developable::detail
