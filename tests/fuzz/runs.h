// SPDX-License-Identifier: GPL-3.0-or-later
// runs.h: every method on one hostile mesh, with options at random, and what is checked of its result.
#pragma once

#include "oracles.h"
#include "random.h"

#include "developable/mesh/mesh.h"

#include <array>
#include <cstdint>

namespace developable::fuzz {

/// Runs one method and checks its result. What it throws is for the caller to judge.
struct Method {
	const char* name;
	void (*run)(Random& random, const PatchAssembly& assembly, Findings& findings);
	double share = 1; ///< of the seeds that it runs on; less for those that take long
};

void runMeasure(Random& random, const PatchAssembly& assembly, Findings& findings);
void runConstrainedNewton(Random& random, const PatchAssembly& assembly, Findings& findings);
void runPenaltyMethod(Random& random, const PatchAssembly& assembly, Findings& findings);
void runLocalMethod(Random& random, const PatchAssembly& assembly, Findings& findings);
void runFlattenPatches(Random& random, const PatchAssembly& assembly, Findings& findings);
void runTriangulatePolygon(Random& random, const PatchAssembly& assembly, Findings& findings);
void runDistancesToSurface(Random& random, const PatchAssembly& assembly, Findings& findings);
void runBoundedStrain(Random& random, const PatchAssembly& assembly, Findings& findings);
void runCutIntoPanels(Random& random, const PatchAssembly& assembly, Findings& findings);
void runReader(Random& random, const PatchAssembly& assembly, Findings& findings);

inline constexpr std::array methods = {Method{"measure", runMeasure},
									   Method{"constrainedNewton", runConstrainedNewton},
									   Method{"penaltyMethod", runPenaltyMethod},
									   Method{"localMethod", runLocalMethod},
									   Method{"flattenPatches", runFlattenPatches},
									   Method{"triangulatePolygon", runTriangulatePolygon},
									   Method{"distancesToSurface", runDistancesToSurface},
									   Method{"boundedStrain", runBoundedStrain, 0.1},
									   Method{"cutIntoPanels", runCutIntoPanels, 0.05},
									   Method{"readPatches", runReader}};

} // namespace developable::fuzz
