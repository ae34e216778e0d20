// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_limits.h: how far the panels of each patch may move.
#pragma once

#include "canonical_form.h"

namespace developable::detail {

/// Of the patches of a canonical form, length there. By default 2 % of the diagonal of a box round each part
/// (what shares vertices or is sewn together): the smallest one along any axes, which does not change with a
/// turn.
/// \param maxDisplacement  for all patches, length in what was given; negative: that default
std::vector<double> displacementLimits(const CanonicalForm& form, double maxDisplacement);

/// The same for patches as they are, along the axes that they have.
std::vector<double> displacementLimits(const PatchAssembly& assembly, double maxDisplacement);

} // namespace developable::detail
