// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_layout.cpp: Newton steps on springs in the plane, with bounds that harden.
#include "bounded_layout.h"

#include "held_grain.h"
#include "plane_springs.h"

#include "developable/descent/descent.h"
#include "developable/linear/linear.h"

namespace developable::detail {

namespace {

StrainedTriangles trianglesOf(const PanelMesh& panel) {
	StrainedTriangles triangles;
	triangles.shaped = triangles.flat = panel.triangles;
	triangles.weights.resize(panel.triangleCount());
	for (int t = 0; t < panel.triangleCount(); ++t)
		triangles.weights[t] = panel.frame(t).normal.norm();
	triangles.weights /= triangles.weights.sum();
	return triangles;
}

/// Lowers springs / scale + Ψ. The springs keep the pattern unique, so Ψ needs no elasticity of its own.
class BoundedLayout {
public:
	BoundedLayout(const PanelMesh& panel, const PlanePositions& start, const StrainBounds& bounds,
				  const Grain& grain, const std::array<int, 2>& longestSide)
		: panel_(panel), springs_(panel), penalty_(trianglesOf(panel), bounds, 0), scale_(springs_.scale()),
		  hessian_(springs_.hessianPattern()), positions_(start) {
		penalty_.watchBorder(start);
		if (!bounds.directed)
			return;
		grain_ = HeldGrain({{penalty_.triangles(), longestSide}}, grain, panel.positions, start);
		penalty_.setGrain(std::vector<double>(panel.triangleCount(), grain_.angles().front()));
	}

	PlanePositions solve(bool onlyWithin) {
		if (violation() <= shareOfTolerance * patternTolerance)
			return positions_;
		Hardening hardening(penalty_);
		int idle = 0, steps = 0; // no good in all, and with the same stiffness
		std::vector<double> violations;
		for (int i = 0; i < mostSteps; ++i) {
			const double decrease = step();
			if (lengthOfStep_ * decrease < settled && violation() <= shareOfTolerance * patternTolerance)
				break;
			if (decrease == 0) {
				if (++idle == patience)
					break;
				hardening.soften();
				violations.clear();
				steps = 0;
			} else if (decrease < slow || ++steps == mostStepsAtOnce) {
				violations.push_back(violation());
				if (onlyWithin && hopeless(violations))
					break;
				if (!hardening.harden() && decrease < least)
					break;
				steps = 0;
			}
		}
		return positions_;
	}

private:
	static constexpr int mostSteps = 400, patience = 5, mostStepsAtOnce = 16;
	static constexpr double slow = 0.5;     // decrease that a step must promise, or the bounds harden
	static constexpr double settled = 1e-3; // within the bounds, a step that brought less is the last
	static constexpr double least = 1e-9;   // beyond them, one that promised less
	static constexpr double shareOfTolerance = 0.3;
	static constexpr double rounding = 1e-13; // of the stiffest bound, beside which springs are soft

	double violation() const { return penalty_.greatestViolation(panel_.positions, positions_); }

	double energy(const PlanePositions& x) const {
		return springs_.guardedEnergy(x) + scale_ * penalty_.value(panel_.positions, x);
	}

	/// \return the decrease that the quadratic model promised, as a share; 0 where no step was any good
	double step() {
		PlanePositions gradient = springs_.gradient(positions_);
		hessian_.setDiagonal(1e-9);
		springs_.addHessian(positions_, true, hessian_);
		for (int t = 0; t < panel_.triangleCount(); ++t)
			addElement(t, gradient);
		addBorder(gradient);
		hessian_.addToDiagonal(rounding);
		if (!factorization_.factorize(hessian_.matrix()))
			return 0;
		const Eigen::VectorXd upward = gradient.reshaped();
		const Eigen::VectorXd direction =
			heldDirection([&](const Eigen::VectorXd& v) { return factorization_.solve(v); }, upward,
						  grain_.slopes(panel_.positions, positions_, false));
		const PlanePositions move = direction.reshaped(2, positions_.cols());
		const double slope = upward.dot(direction), before = energy(positions_);
		double length = std::min(1.0, 0.9 * springs_.longestStep(positions_, move));
		for (int trial = 0; trial < 30; ++trial, length /= 2) {
			PlanePositions next = positions_ + length * move;
			grain_.align(panel_.positions, next);
			if (!descendsEnough(before, slope, length, energy(next)))
				continue;
			positions_ = next;
			lengthOfStep_ = length;
			return -slope / std::abs(before);
		}
		return 0;
	}

	void addElement(int t, PlanePositions& gradient) {
		const StrainPenalty::FlatElement element = penalty_.flatElement(t, panel_.positions, positions_);
		const auto corners = panel_.triangles.col(t);
		for (int row = 0; row < 3; ++row) {
			gradient.col(corners[row]) += scale_ * element.gradient.segment<2>(2 * row);
			for (int column = 0; column <= row; ++column) {
				Eigen::Matrix2d block = element.hessian.block<2, 2>(2 * row, 2 * column);
				if (row == column)
					block(0, 1) = block(1, 0);
				hessian_.add(corners[row], corners[column], scale_ * block);
			}
		}
	}

	void addBorder(PlanePositions& gradient) {
		for (const BorderFans::EdgeElement& element : penalty_.borderElements(positions_))
			for (int row = 0; row < 2; ++row) {
				gradient.col(element.ends[row]) += scale_ * element.gradient.segment<2>(2 * row);
				for (int column = 0; column <= row; ++column)
					hessian_.add(element.ends[row], element.ends[column],
								 scale_ * element.hessian.block<2, 2>(2 * row, 2 * column));
			}
	}

	const PanelMesh& panel_;
	PlaneSprings springs_;
	StrainPenalty penalty_;
	HeldGrain grain_;
	const double scale_;
	PlaneHessian hessian_;
	SparseCholesky factorization_; // CG on an old factor would not do while bounds harden
	PlanePositions positions_;
	double lengthOfStep_ = 1; // of the last one, as a share of that of the quadratic model
};

} // namespace

PlanePositions boundedLayout(const PanelMesh& panel, const PlanePositions& start, const StrainBounds& bounds,
							 const Grain& grain, const std::array<int, 2>& longestSide, bool onlyWithin) {
	if (countFlipped(panel.triangles, start) > 0)
		return start;
	return BoundedLayout(panel, start, bounds, grain, longestSide).solve(onlyWithin);
}

} // namespace developable::detail
