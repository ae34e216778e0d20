// SPDX-License-Identifier: GPL-3.0-or-later
// penalty_method.h: the front door of penalty/: the paper's global method (Section 4).
//
// A penalty function is lowered by conjugate gradients.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

struct PenaltyMethodOptions {
	double angleTolerance = 1e-4; ///< a copy with a smaller angle defect is a developable point, rad
	/// η: stop when an outer step changes G by less than this share of its start
	double relativeChange = 1e-4;
	int maxIterations = 200; ///< N_max, outer steps
};

/// Minimises E + ρ/2 · G² with a growing ρ (Section 4.1); linked copies move as one (Section 4.2).
/// \param positions  3 x places, in the mesh's unit of length: in, the start;
///                   out, the result, or unchanged when stopped
/// \param progress   is told the share of the outer steps that is done, and may ask for a stop
/// \return           how the run ended, and after how many outer steps
/// \throws ClosedPatch, NothingFree
/// \throws InvalidParameter  when an option is out of its range
OptimizationReport penaltyMethod(const PatchAssembly& assembly, Positions& positions,
								 const PenaltyMethodOptions& options, const Progress& progress = {});

} // namespace developable
