// SPDX-License-Identifier: GPL-3.0-or-later
// border_limits.h: what a border may not do: kink, or overlap itself when laid flat.
#pragma once

#include "rods.h"

namespace developable::detail {

/// Where a border turns, and by how much it may. Gradients are in closed form.
class BorderTurns {
public:
	/// Each border vertex of each patch, corners included; where two patches have the same one it counts
	/// once. \param more  than in the original shape, rad
	BorderTurns(const PatchAssembly& assembly, double more);

	const std::vector<RodJoint>& joints() const { return joints_; }

	/// How much each turns too much, rad; 0 where it does not.
	Eigen::VectorXd excess(const Positions& positions) const;

	/// The axis about which a border turns at a joint, one long; 0 where it runs straight on.
	Eigen::Vector3d axis(int joint, const Positions& positions) const;

	/// By how much a border turns too much about an axis, rad, less than 0 where it does not; and the
	/// gradient with respect to the joint's three places if they move such that the axis stays that of the
	/// turn, 3 x 3, rad/length.
	double excessAbout(const Eigen::Vector3d& axis, int joint, const Positions& positions) const;
	Eigen::Matrix3d gradientAbout(const Eigen::Vector3d& axis, int joint, const Positions& positions) const;

private:
	std::vector<RodJoint> joints_;
	Eigen::VectorXd most_;
	Eigen::Matrix2Xd mostDirection_; ///< its cosine and sine
};

/// The copies on boundaries whose angles may come to exceed 2π, for they have more than two triangles.
std::vector<int> copiesThatMayOverlap(const PatchAssembly& assembly);

} // namespace developable::detail
