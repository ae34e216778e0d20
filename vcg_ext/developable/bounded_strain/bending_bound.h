// SPDX-License-Identifier: GPL-3.0-or-later
// bending_bound.h: what it costs to bend a sheet to less than the radius that it bears.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"

#include <vector>

namespace developable::detail {

/// What is asked of bending.
struct BendingLimit {
	double radius = 0; ///< the least there may be, length; 0: nothing is asked
	double force = 0;  ///< f of a BendingBound
};

/// Σ m h(|x''| r − 1) over the vertex copies: x'' are the second derivatives of the positions along the
/// tangent plane, whose norm is the curvature of a developable surface, r is a radius just above the limit, m
/// the copy's share of the area, and h(c) = f/2 (c + √(c² + δ²)). As its slope ends at f, this gives way
/// where the bounds of strain leave no other choice. Convex while the tangent planes are those of one shape.
class BendingBound {
public:
	using Entries = std::vector<Eigen::Triplet<double>>;

	BendingBound(const PatchAssembly& assembly, const BendingLimit& limit);

	/// From now on tangent planes are those of this shape.
	void take(const Positions& shape);

	/// \param width  δ
	void harden(double width) { width_ = width; }

	double value(const Positions& shape) const;

	/// Adds the derivatives by the shape's coordinates, the second ones to the lower triangle; those of
	/// places that are held still stay out, and so do copies where the cost has next to no slope.
	void addDerivatives(const Positions& shape, Eigen::VectorXd& gradient, Entries& entries) const;

private:
	using Vector9 = Eigen::Matrix<double, 9, 1>;
	using Matrix9 = Eigen::Matrix<double, 9, 9>;

	struct Slope {
		double value, first, second; // of h
	};

	/// x_xx, √2 x_xy and x_yy below each other, times the radius.
	Vector9 bent(const SecondDerivatives& at, const Positions& shape) const;
	Slope slope(double excess) const;
	/// \param hessian  by what bent returns
	void addHessian(const SecondDerivatives& at, const Matrix9& hessian, Entries& entries) const;

	const PatchAssembly& assembly_;
	const double radius_, force_;
	double width_ = 1;
	Eigen::VectorXd masses_; // per copy
	std::vector<SecondDerivatives> derivatives_;
};

} // namespace developable::detail
