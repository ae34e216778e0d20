// SPDX-License-Identifier: GPL-3.0-or-later
// cut_into_panels.cpp: the filter Cut into Developable Panels.
#include "../cut_layer.h"
#include "../materials.h"
#include "../shared_parameters.h"
#include "filters.h"

#include "developable/panels/cut_into_panels.h"
#include "developable/vcg_mesh/vcg_mesh.h"

#include <algorithm>
#include <chrono>

namespace developable::plugin {

namespace {

CutOptions optionsOf(const ParameterValues& values, int lengthExponent) {
	CutOptions options;
	options.maxDisplacement = inWorkingUnits(lengthExponent, values.number("max_displacement"));
	options.material = {strainBounds(values), chosenGrain(values), chosenSmoothness(values)};
	options.maxPanels = values.integer("max_panels");
	options.darts = values.boolean("darts");
	options.creaseAngle = values.number("crease_angle");
	options.symmetric = values.boolean("symmetric");
	options.keepSelected = values.boolean("keep_selected_whole");
	options.splitTriangles = values.boolean("cut");
	return options;
}

void toMeshUnits(int lengthExponent, CutReport& report) {
	const auto inUnits = [=](double& value, int lengthPower = 1) {
		value = inMeshUnits(lengthExponent, value, lengthPower);
	};
	inUnits(report.seamLength);
	inUnits(report.smallestPanelArea, 2);
	inUnits(report.meanDisplacement);
	inUnits(report.maxDisplacement);
	for (CutPanel& panel : report.panels) {
		inUnits(panel.area, 2);
		inUnits(panel.meanDisplacement);
		inUnits(panel.maxDisplacement);
		panel.worstPoint = inMeshUnits(lengthExponent, panel.worstPoint);
		panel.seamPoint = inMeshUnits(lengthExponent, panel.seamPoint);
	}
}

Results resultsOf(const CutReport& report, double seconds) {
	return {
		{"panels", static_cast<int>(report.panels.size()), ""},
		{"darts", report.darts, ""},
		{"seam_length", report.seamLength, ""},
		{"smallest_panel_area", report.smallestPanelArea, ""},
		{"mean_displacement", report.meanDisplacement, ""},
		{"max_displacement", report.maxDisplacement, ""},
		{"converged", converged(report.status), ""},
		{"status", static_cast<int>(report.status), describe(report.status)},
		{"seconds", seconds, ""},
	};
}

/// Why a panel has its longest seam, or does not hold; empty when there is nothing to say.
std::string reasonOf(const CutPanel& panel) {
	if (panel.neighbour < 0 || !panel.developable)
		return {};
	return reasonInWords(Status::Converged, panel.reason,
						 {{"neighbour", panel.neighbour, ""},
						  {"seam_x", panel.seamPoint[0], ""},
						  {"seam_y", panel.seamPoint[1], ""},
						  {"seam_z", panel.seamPoint[2], ""}});
}

void logReasons(const FilterCall& call, const CutReport& report) {
	constexpr std::size_t mostLines = 20;
	for (std::size_t panel = 0; panel < std::min(mostLines, report.panels.size()); ++panel)
		if (const std::string reason = reasonOf(report.panels[panel]); !reason.empty())
			call.log("panel " + std::to_string(panel) + ": " + reason);
}

Results runCut(FilterCall& call) {
	const auto start = std::chrono::steady_clock::now();
	PatchOptions patches = patchOptions(call.values);
	const TriangleMesh mesh = readTriangles(call.layer.mesh(), patches.seams);
	patches.weldDistance = inWorkingUnits(mesh.lengthExponent, patches.weldDistance);
	CutResult result =
		cutIntoPanels(mesh, patches, optionsOf(call.values, mesh.lengthExponent), call.progress);
	toMeshUnits(mesh.lengthExponent, result.report);
	if (result.report.status != Status::Stopped) {
		std::vector<int> faces = result.mesh.face;
		if (call.values.boolean("cut")) {
			faces = result.mesh.facesAfter(static_cast<int>(call.layer.mesh().face.size()));
			cutLayer(call.layer, result.mesh, mesh.singlePrecision);
		}
		labelPanels(call.layer, result, faces);
		if (call.values.boolean("colorize"))
			colourPanels(call.layer, result, faces);
		logReasons(call, result.report);
		for (const std::string& note : result.report.notes)
			call.log(note);
	}
	const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
	return resultsOf(result.report, elapsed.count());
}

std::vector<Parameter> cutParameters() {
	std::vector<Parameter> result = {
		patchesParameter(),
		weldDistanceParameter(),
		onlySelectedParameter(),
		boolParameter("keep_selected_whole", false, "Keep selected faces whole",
					  "No seam and no dart crosses a selected face."),
		automaticLength("max_displacement", "Panels may move by",
						"How far a vertex may move when the panels are made developable; -1 means 2 % of the "
						"diagonal of each part. A part is what shares vertices or is sewn together."),
	};
	const std::vector<Parameter> materials = materialParameters();
	result.insert(result.end(), materials.begin(), materials.end());
	const std::vector<Parameter> others = {
		intParameter(
			"max_panels", 0, 0, "Panels at most",
			"So many panels at most, even if some then can't be made developable within the largest "
			"displacement; 0 means as many as it takes. Clusters of faces with like normals are joined across "
			"their longest seams, wherever the constrained Newton method still makes the union "
			"developable and it lies flat without overlap."),
		boolParameter("darts", true, "Darts",
					  "Where a cut from the border is enough a panel stays whole and gets a dart."),
		floatParameter("crease_angle", 40, {0, false, 180}, "°", "Sharp edges turn by",
					   "Seams like to lie on edges whose faces make a sharper turn than this."),
		boolParameter(
			"symmetric", false, "Left mirrors right",
			"Left and right panels of a surface that is its own mirror image mirror each other, and have no darts."),
		boolParameter(
			"cut", true, "Cut open",
			"Double the vertices along seams and darts, and split faces where seams cross them; else "
			"faces are only labelled. Doubled vertices coincide, so that they stay sewn."),
		boolParameter("colorize", true, "Colour the faces", "Colour the faces by panel."),
	};
	result.insert(result.end(), others.begin(), others.end());
	return result;
}

} // namespace

FilterDescription panelCutting() {
	FilterDescription filter;
	filter.name = "Cut into Developable Panels";
	filter.pythonName = "meshing_cut_into_developable_panels";
	filter.shortName = "cut";
	filter.filterClass = FilterClass::Remeshing;
	filter.change = Change::Panels;
	filter.help =
		"Cuts a surface, open or closed, into few <b>panels</b> that can each be made <b>developable</b>, so that "
		"they can be cut from a flat sheet, without any point moving farther than you allow, along short and "
		"smooth seams and <b>darts</b>. Nothing moves: the faces get the number of their panel as quality and a "
		"colour for each, and vertices along seams and darts are doubled, which coincide and so stay sewn. Run "
		"<b>Global Developability</b> next, with its defaults, and then <b>Flatten Patches</b>.<br><br>"
		"Panels that are there are only cut further. There is no undo: save the layer before, or copy it. Help "
		"explains each setting.<br><br>"
		"See: <i>D. Cohen-Steiner, P. Alliez, M. Desbrun</i>, <b>Variational Shape Approximation</b>, ACM "
		"Transactions on Graphics 23, 2004, for the clusters.";
	filter.parameters = cutParameters();
	filter.run = runCut;
	return filter;
}

} // namespace developable::plugin
