// SPDX-License-Identifier: GPL-3.0-or-later
// panel_output.h: what became of each patch, in the log and as attributes of the faces.
#pragma once

#include "filter_call.h"

#include "developable/geometry/geometry.h"

namespace developable::plugin {

/// One patch before and after an optimisation.
struct PanelReport {
	PatchVerdict verdict;
	PatchMeasures before, after;
};

/// Of all patches. Where the method tells no patches apart, those within the angle tolerance have converged
/// and the others ended as the run did.
std::vector<PanelReport> panelReports(const PatchAssembly& assembly, const Positions& positions,
									  const OptimizationReport& report, double angleTolerance);

/// How many patches have that status.
int countPanels(const std::vector<PanelReport>& panels, Status status);

/// A line a patch, or the twenty with most curvature left and a line for the others.
void logPanels(const FilterCall& call, const std::vector<PanelReport>& panels);

/// Writes the face attributes `panel` (-1 for faces that were not worked on) and `panel_status`,
/// `panel_reason`, `panel_curvature_before`, `panel_curvature`, `panel_max_angle_defect`,
/// `panel_mean_displacement`, `panel_max_displacement`, `panel_nearest_developable`, `panel_border_overlaps`,
/// `panel_worst_point`; and `panel_stretch`, -1, as no strains are measured here.
void writePanels(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<PanelReport>& panels);

} // namespace developable::plugin
