// SPDX-License-Identifier: GPL-3.0-or-later
// unfairness.h: what a fair shape of a surface has least of.
#pragma once

#include "newton_tuning.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

/// φ of a fairness f: waves shorter than f times the root of their part's area are smoothed away.
double shapeSmoothness(double fairness);

/// How far a shape is from its original, and how much it bends:
///     ‖s(x) − x‖₂² + ‖s(x) − x‖₄² + φ A_o² / A ∫ |x''|²,
/// s(x) being the point of the original surface that is nearest to a place x, and the norms those of
/// distances, with the places' shares of the area as weights. The second of them keeps single places from
/// going far. x'' is taken on the surface x itself; A_o is the area of what hangs together, A that of all. So
/// a place may slide along the surface, which lets jagged seams become smooth.
class Unfairness {
public:
	/// \param shapeSmoothness  φ, without unit
	/// \param memoryLimit      see SparseSolver
	Unfairness(const PatchAssembly& original, double shapeSmoothness, const NewtonTuning& tuning,
			   double memoryLimit);

	const PatchAssembly& original() const { return original_; }
	double shapeSmoothness() const { return shapeSmoothness_; }

	/// Length².
	double at(const Positions& positions) const;

	struct Step {
		Positions move; ///< held places stay; nothing where rounding spoils the system
		/// What the second norm adds to the share of the area that each place has.
		Eigen::VectorXd extraMasses;
	};

	/// A step of Newton's method.
	Step step(const Positions& positions) const;

private:
	Positions toOriginal(const Positions& positions) const;

	const PatchAssembly& original_;
	const double shapeSmoothness_; // φ
	NewtonTuning tuning_;
	const double memoryLimit_;
};

} // namespace developable::detail
