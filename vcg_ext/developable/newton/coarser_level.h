// SPDX-License-Identifier: GPL-3.0-or-later
// coarser_level.h: coarse levels of the constrained Newton method, for other methods.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The same patches with so many places, or more where no more can go (see detail::Coarsening).
PartialAssembly coarserLevel(const PatchAssembly& assembly, int placesWanted);

/// The displacement of all fine places that is nearest to that of the coarse ones without bending on the
/// scale of the coarse edges (see detail::Prolongation). \return 3 x fine places
Positions carriedOver(const PatchAssembly& fine, const PartialAssembly& coarse,
					  const Positions& coarseDisplacement);

} // namespace developable
