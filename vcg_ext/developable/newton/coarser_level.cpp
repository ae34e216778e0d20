// SPDX-License-Identifier: GPL-3.0-or-later
// coarser_level.cpp: coarsening and prolongation with the method's own constants.
#include "coarser_level.h"

#include "coarsening.h"
#include "prolongation.h"

namespace developable {

PartialAssembly coarserLevel(const PatchAssembly& assembly, int placesWanted) {
	return detail::Coarsening(assembly, NewtonTuning()).coarsen(placesWanted);
}

Positions carriedOver(const PatchAssembly& fine, const PartialAssembly& coarse,
					  const Positions& coarseDisplacement) {
	detail::BendingMatrix bending(fine);
	return detail::Prolongation(fine, coarse, bending, NewtonTuning()).of(coarseDisplacement);
}

} // namespace developable
