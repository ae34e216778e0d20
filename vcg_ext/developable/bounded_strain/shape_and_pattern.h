// SPDX-License-Identifier: GPL-3.0-or-later
// shape_and_pattern.h: Newton steps that move a shape and its pattern together.
#pragma once

#include "bending_bound.h"
#include "displacement_bound.h"

#include "developable/flatten/flatten.h"
#include "developable/linear/linear.h"
#include "developable/material/material.h"
#include "developable/newton/constrained_newton.h"

namespace developable::detail {

/// The unknowns.
struct ShapeAndPattern {
	Positions shape;          ///< 3 x places; those that are held still stay
	Eigen::Matrix2Xd pattern; ///< 2 x vertices of the patterns
};

/// Steps that lower φ = ½‖x − x*‖²_W / A + Ψ + Σ m p(|d| / r − 1) + what a BendingBound says, A being the
/// object's area, x* what the shape is to be near, Ψ the cost of strain, and the sum that of moving too far.
/// The pattern turns far for small strains, where linear steps go wrong; so after each trial step it settles
/// by itself.
class ShapeAndPatternSteps {
public:
	/// \param grain  against which no piece turns
	ShapeAndPatternSteps(const PatchAssembly& assembly, const Nearness& nearness,
						 const DisplacementBound& bound, BendingBound& bending, const StrainPenalty& penalty,
						 const HeldGrain& grain);

	/// \return the decrease of φ that the quadratic model promised, as a share; 0 where no step was any good
	double step(ShapeAndPattern& unknowns);

	/// ½‖x − x*‖²_W / A.
	double distanceCost(const Positions& shape) const {
		return nearness_.squaredDistance(shape) / (2 * area_);
	}

	/// Whether the last step's system could be solved.
	bool solvable() const { return solvable_; }

private:
	using Entries = RepeatedSum::Entries;

	/// Linear systems of one pattern.
	struct System {
		RepeatedSum matrix;
		SparseCholesky factorization;
	};

	double value(const ShapeAndPattern& unknowns) const;
	Eigen::VectorXd direction(const ShapeAndPattern& unknowns, Eigen::VectorXd& gradient);
	void addMetric(const Positions& shape, Eigen::VectorXd& gradient, Entries& entries) const;
	void addBound(const Positions& shape, Eigen::VectorXd& gradient, Entries& entries) const;
	void addElement(int triangle, const StrainPenalty::Element& element, Eigen::VectorXd& gradient,
					Entries& entries) const;
	void addBorder(const Eigen::Matrix2Xd& pattern, int first, Eigen::VectorXd& gradient,
				   Entries& entries) const;
	bool factorize(System& system, int size, Entries& entries, int firstOfPattern) const;

	/// Lowers Ψ by moving the pattern alone.
	void settle(ShapeAndPattern& unknowns);
	bool settleOnce(ShapeAndPattern& unknowns, double& value);

	const PatchAssembly& assembly_;
	const Nearness& nearness_;
	const DisplacementBound& bound_;
	BendingBound& bending_;
	const StrainPenalty& penalty_;
	const HeldGrain& grain_;
	const TriangleOrder order_;
	const double area_;
	System whole_, pattern_;
	double lastLength_ = 1; // of a step: the next one is not tried at more than four times that
	bool solvable_ = true;
};

} // namespace developable::detail
