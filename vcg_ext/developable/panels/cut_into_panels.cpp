// SPDX-License-Identifier: GPL-3.0-or-later
// cut_into_panels.cpp: the order of the work, from patches to panels that are sewn together.
#include "cut_into_panels.h"

#include "panel_plan.h"

namespace developable {

CutResult cutIntoPanels(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
						const Progress& progress) {
	requireOption(options.maxPanels >= 0, "The largest number of panels must be 0 or more.");
	requireOption(options.creaseAngle >= 0 && options.creaseAngle <= 180,
				  "The crease angle must be between 0 and 180 degrees.");
	requireOption(!std::isnan(options.maxDisplacement) && !std::isinf(options.maxDisplacement),
				  "The greatest displacement must be a number.");
	requireValid(options.material.bounds);
	return detail::PanelPlan(detail::separatePatches(mesh, patches), options, neverBack(progress)).run();
}

} // namespace developable
