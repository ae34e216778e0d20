// SPDX-License-Identifier: GPL-3.0-or-later
// optimize_layer.h: the work flow of every optimisation, from the mesh to the mesh.
#pragma once

#include "filter_call.h"
#include "results.h"

#include "developable/mesh/mesh.h"

namespace developable::plugin {

/// Changes the positions, 3 x places, to a more developable shape; leaves them as they were when it is
/// stopped.
using Method = std::function<OptimizationReport(const PatchAssembly&, Positions&, const Progress&)>;

struct Optimized {
	PatchAssembly assembly;
	Positions positions; ///< as the mesh holds them now
	Results results;
	bool stopped = false; ///< by the user: the mesh is untouched
};

/// Reads the layer, runs the method, measures what the host's scalar keeps of the result and writes it back
/// with the chosen map. Nothing is written before everything is computed, nor when the user stopped the run.
Optimized optimizeLayer(FilterCall& call, const Method& method);

} // namespace developable::plugin
