// SPDX-License-Identifier: GPL-3.0-or-later
// prolongation.h: from the displacement of a coarse assembly to one of the fine assembly.
#pragma once

#include "bending_matrix.h"
#include "newton_tuning.h"

namespace developable::detail {

/// The displacement of all fine places that is nearest to a coarse one without bending on the scale of the
/// coarse edges: with m_c the masses of the coarse places and n_c their number, it has the least
///     Σ_c m_c |d_c − d̂_c|² + β ∫|d''|²,   β = NewtonTuning::prolongationBending (A/n_c)²,
/// so waves shorter than some five coarse edges are left out: they belong to the coarse triangulation. The
/// system does not depend on the coarse displacement, and can be factorised before that is known.
class Prolongation {
public:
	/// \param bending      of the fine assembly; kept as a reference
	/// \param placeOrder   see eliminationOrder; empty: found here
	/// \param memoryLimit  see SparseSolver
	Prolongation(const PatchAssembly& fine, const PartialAssembly& coarse, BendingMatrix& bending,
				 const NewtonTuning& tuning, const std::vector<int>& placeOrder = {}, double memoryLimit = 0);

	/// \return 3 x fine places
	Positions of(const Positions& coarseDisplacement) const;

	/// The displacement, nearest to none in the same sense, after which the surface has no waves of that kind
	/// either: its own curvature on a scale that the coarse assembly does not have.
	/// \param positions  3 x fine places
	Positions smoothing(const Positions& positions) const;

private:
	BendingMatrix& bending_;
	const Smoothness smoothness_;
	const std::vector<int> placeOfCoarse_;
	const Eigen::VectorXd coarseMasses_;
	const Eigen::Index places_; ///< of the fine assembly
	SparseSolver solver_;
	bool solvable_ = false;
};

} // namespace developable::detail
