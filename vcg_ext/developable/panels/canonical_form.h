// SPDX-License-Identifier: GPL-3.0-or-later
// canonical_form.h: a copy of a surface that is the same wherever the surface is, however it is turned, how
// large it is, and in what order its vertices and triangles are.
#pragma once

#include "planned_surface.h"

#include <Eigen/Geometry>

namespace developable::detail {

/// Which unions hold is often decided by a hair, so that a rounding may change all that follows: two copies
/// of a surface get the same panels only where every bit is the same. So the work is done on this form:
/// about the centre of area, in units of the root of the mean square distance from it, along the principal
/// axes, coordinates rounded to what turning a mesh in double precision can't reach, vertices and triangles
/// in the order of their coordinates. Where axes or their directions are not unique, forms are made for all
/// that may be meant, and the first in lexicographic order is taken: then they only differ where the surface
/// does not. The axes stay as they are where too many may be meant, and nothing is moved where there are
/// details too fine to be rounded.
class CanonicalForm {
public:
	/// \param given  outlives this
	explicit CanonicalForm(const GivenPatches& given);

	/// Every copy of a vertex is a vertex here, and every triangle a face.
	const GivenPatches& patches() const { return form_; }

	/// \return  a length here
	double inForm(double length) const { return length / scale_; }
	double inGiven(double length) const { return length * scale_; }
	Eigen::Vector3d directionInForm(const Eigen::Vector3d& direction) const { return turn_ * direction; }
	/// The same points along the axes of what was given.
	Positions alongGivenAxes(const Positions& positions) const { return turn_.transpose() * positions; }

	/// Per triangle here, the one of what was given.
	const std::vector<int>& trianglesGiven() const { return triangles_; }

	/// Panels found here on what was given, whose points they have to the last bit, in its order.
	PlannedSurface carriedBack(const PlannedSurface& planned) const;

private:
	void sortAndRound(double side);

	const GivenPatches& given_;
	GivenPatches form_;
	Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
	double scale_ = 1;
	Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity(); ///< from what was given
	std::vector<int> vertices_, triangles_;              ///< of what was given, per vertex and triangle here
	std::vector<int> firstCorner_; ///< per triangle here, which corner of the given one comes first
};

} // namespace developable::detail
