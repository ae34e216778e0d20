// SPDX-License-Identifier: GPL-3.0-or-later
// panel_output.cpp: patches told apart.
#include "panel_output.h"

#include "face_data.h"
#include "results.h"

#include <algorithm>
#include <numeric>

namespace developable::plugin {

namespace {

constexpr std::size_t mostLines = 20; ///< in the log

std::string reasonOf(const PanelReport& panel) {
	if (panel.verdict.reason != Reason::BorderOverlaps)
		return describe(panel.verdict.status);
	const Eigen::Vector3d& worst = panel.after.worstPoint;
	return reasonInWords(panel.verdict.status, panel.verdict.reason,
						 {{"border_overlaps", panel.verdict.borderOverlaps, ""},
						  {"worst_x", worst[0], ""},
						  {"worst_y", worst[1], ""},
						  {"worst_z", worst[2], ""}});
}

std::string inWords(const PanelReport& panel) {
	const PatchMeasures &before = panel.before, &after = panel.after;
	const auto number = [](double value) { return formatted(value, 4); };
	std::string words = reasonOf(panel) + "; " + std::to_string(after.faces) + " faces, C " +
						number(before.curvature) + " to " + number(after.curvature) +
						" rad, largest angle defect " + number(after.maxAngleDefect) + " rad, moved " +
						number(after.meanDisplacement) + " on average and " + number(after.maxDisplacement) +
						" at most";
	if (!converged(panel.verdict.status) && panel.verdict.reason != Reason::BorderOverlaps)
		words += "; most curvature is left at (" + number(after.worstPoint[0]) + ", " +
				 number(after.worstPoint[1]) + ", " + number(after.worstPoint[2]) + ")";
	if (panel.verdict.nearestDevelopable > 0)
		words += "; the nearest developable shape found moves a vertex by " +
				 number(panel.verdict.nearestDevelopable);
	return words;
}

std::vector<PatchMeasures> measuresInMeshUnits(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<PatchMeasures> measures = measurePatches(assembly, positions);
	for (PatchMeasures& patch : measures) {
		patch.worstPoint = inMeshUnits(assembly.lengthExponent, patch.worstPoint);
		for (double* length : {&patch.meanDisplacement, &patch.maxDisplacement})
			*length = inMeshUnits(assembly.lengthExponent, *length);
	}
	return measures;
}

PatchVerdict verdictOf(const PatchMeasures& before, const PatchMeasures& after, Status ofAll,
					   double angleTolerance) {
	if (after.maxAngleDefect > angleTolerance)
		return {ofAll};
	return {before.maxAngleDefect > angleTolerance || after.maxDisplacement > 0 ? Status::Converged
																				: Status::NothingToDo};
}

/// Where the angles at the border of a patch add up to most.
Eigen::Vector3d widestBorderPoint(const PatchAssembly& assembly, const Positions& positions,
								  const Eigen::VectorXd& angles, int patch) {
	int widest = 0;
	double most = -1;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.patchOfCopy[copy] == patch && angles[copy] > most) {
			most = angles[copy];
			widest = assembly.placeOfCopy[copy];
		}
	return positions.col(widest);
}

} // namespace

std::vector<PanelReport> panelReports(const PatchAssembly& assembly, const Positions& positions,
									  const OptimizationReport& report, double angleTolerance) {
	const std::vector<PatchMeasures> before = measuresInMeshUnits(assembly, assembly.originalPositions),
									 after = measuresInMeshUnits(assembly, positions);
	const Eigen::VectorXd angles = borderAngles(assembly, positions);
	std::vector<PanelReport> panels;
	for (std::size_t i = 0; i < after.size(); ++i)
		panels.push_back({report.patchVerdicts.empty()
							  ? verdictOf(before[i], after[i], report.status, angleTolerance)
							  : report.patchVerdicts[i],
						  before[i], after[i]});
	for (std::size_t i = 0; i < panels.size(); ++i)
		if (panels[i].verdict.reason == Reason::BorderOverlaps)
			panels[i].after.worstPoint =
				inMeshUnits(assembly.lengthExponent, widestBorderPoint(assembly, positions, angles, int(i)));
	return panels;
}

int countPanels(const std::vector<PanelReport>& panels, Status status) {
	return static_cast<int>(std::count_if(panels.begin(), panels.end(), [status](const PanelReport& panel) {
		return panel.verdict.status == status;
	}));
}

void logPanels(const FilterCall& call, const std::vector<PanelReport>& panels) {
	std::vector<std::size_t> order(panels.size());
	std::iota(order.begin(), order.end(), 0);
	if (panels.size() > mostLines) {
		std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
			return panels[a].after.curvature > panels[b].after.curvature;
		});
		order.resize(mostLines);
	}
	for (const std::size_t i : order)
		call.log("panel " + std::to_string(i) + ": " + inWords(panels[i]));
	if (panels.size() > mostLines)
		call.log("other panels: " + std::to_string(panels.size() - mostLines) + ", with less curvature left");
}

void writePanels(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<PanelReport>& panels) {
	const auto write = [&](const char* name, const auto& value, double elsewhere = 0) {
		Eigen::VectorXd values(panels.size());
		for (std::size_t i = 0; i < panels.size(); ++i)
			values[Eigen::Index(i)] = value(panels[i]);
		writeFaceScalars(mesh, name, assembly, values, elsewhere);
	};
	writeFaceScalars(mesh, "panel", assembly,
					 Eigen::VectorXd::LinSpaced(Eigen::Index(panels.size()), 0, double(panels.size()) - 1),
					 -1);
	write(
		"panel_status", [](const PanelReport& panel) { return static_cast<int>(panel.verdict.status); }, -1);
	write("panel_reason", [](const PanelReport& panel) { return static_cast<int>(panel.verdict.reason); });
	write("panel_curvature_before", [](const PanelReport& panel) { return panel.before.curvature; });
	write("panel_curvature", [](const PanelReport& panel) { return panel.after.curvature; });
	write("panel_max_angle_defect", [](const PanelReport& panel) { return panel.after.maxAngleDefect; });
	write("panel_mean_displacement", [](const PanelReport& panel) { return panel.after.meanDisplacement; });
	write("panel_max_displacement", [](const PanelReport& panel) { return panel.after.maxDisplacement; });
	write("panel_nearest_developable",
		  [](const PanelReport& panel) { return panel.verdict.nearestDevelopable; });
	write("panel_border_overlaps", [](const PanelReport& panel) { return panel.verdict.borderOverlaps; });
	write(
		"panel_stretch", [](const PanelReport&) { return -1; }, -1);
	Positions worst(3, panels.size());
	for (std::size_t i = 0; i < panels.size(); ++i)
		worst.col(Eigen::Index(i)) = panels[i].after.worstPoint;
	writeFacePoints(mesh, "panel_worst_point", assembly, worst);
}

} // namespace developable::plugin
