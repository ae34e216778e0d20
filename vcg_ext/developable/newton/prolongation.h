// SPDX-License-Identifier: GPL-3.0-or-later
// prolongation.h: from the displacement of a coarse assembly to one of the fine assembly.
#pragma once

#include "bending_metric.h"

namespace developable::detail {

/// The displacement of all fine places that is nearest to a coarse one without bending on the scale of the
/// coarse edges: with m_c the masses of the coarse places and n_c their number, it has the least
///     Σ_c m_c |d_c − d̂_c|² + β ∫|d''|²,   β = NewtonTuning::prolongationBending (A/n_c)²,
/// so waves shorter than some five coarse edges are left out: they belong to the coarse triangulation.
/// \param memoryLimit  see SparseSolver
/// \return             3 x fine places
Positions prolonged(const PatchAssembly& fine, const PartialAssembly& coarse,
					const Positions& coarseDisplacement, const NewtonTuning& tuning, double memoryLimit = 0);

} // namespace developable::detail
