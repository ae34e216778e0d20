// SPDX-License-Identifier: GPL-3.0-or-later
// fair_shape.h: the original without its small bumps.
#pragma once

#include "curvature_goal.h"
#include "newton_tuning.h"

namespace developable::detail {

/// φ of a fairness f: waves shorter than f times the root of their patch's area are smoothed away.
double shapeSmoothness(double fairness);

/// The assembly with other original positions x, of which Σ_q m_q |x_q − s(x_q)|² / A + φ Σ_p A_p² / A ∫_p
/// |x''|² is nearly the least: s(x_q) is the point of the original surface that is nearest to x_q, and the
/// second derivatives are taken on the surface x itself. So a place may slide along the surface, which lets
/// jagged seams become smooth, and only what bends the surface is smoothed away. Held places stay, and no
/// place moves farther than the goal allows.
///
/// \param shapeSmoothness  φ, without unit
/// \param memoryLimit      see SparseSolver
PatchAssembly fairShape(const PatchAssembly& assembly, double shapeSmoothness, const CurvatureGoal& goal,
						const NewtonTuning& tuning, double memoryLimit);

} // namespace developable::detail
