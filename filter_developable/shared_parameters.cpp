// SPDX-License-Identifier: GPL-3.0-or-later
// shared_parameters.cpp: labels, tooltips and defaults of the parameters that several filters share.
#include "shared_parameters.h"

#include "developable/mesh/mesh.h"

namespace developable::plugin {

Parameter boolParameter(std::string name, bool defaultValue, std::string label, std::string tooltip) {
	Parameter parameter;
	parameter.name = std::move(name);
	parameter.type = ParameterType::Bool;
	parameter.defaultValue = defaultValue;
	parameter.label = std::move(label);
	parameter.tooltip = std::move(tooltip);
	return parameter;
}

Parameter intParameter(std::string name, int defaultValue, int minimum, std::string label,
					   std::string tooltip) {
	Parameter parameter = boolParameter(std::move(name), false, std::move(label), std::move(tooltip));
	parameter.type = ParameterType::Int;
	parameter.defaultValue = defaultValue;
	parameter.range.minimum = minimum;
	return parameter;
}

Parameter floatParameter(std::string name, double defaultValue, Range range, std::string unit,
						 std::string label, std::string tooltip) {
	Parameter parameter = boolParameter(std::move(name), false, std::move(label), std::move(tooltip));
	parameter.type = ParameterType::Float;
	parameter.defaultValue = defaultValue;
	parameter.range = range;
	parameter.unit = std::move(unit);
	return parameter;
}

Parameter enumeration(std::string name, std::vector<std::string> values, int defaultIndex, std::string label,
					  std::string tooltip) {
	Parameter parameter = boolParameter(std::move(name), false, std::move(label), std::move(tooltip));
	parameter.type = ParameterType::Enumeration;
	parameter.defaultValue = defaultIndex;
	parameter.values = std::move(values);
	return parameter;
}

Parameter lengthParameter(std::string name, double defaultValue, std::string label, std::string tooltip) {
	Parameter parameter =
		floatParameter(std::move(name), defaultValue, {0}, "length", std::move(label), std::move(tooltip));
	parameter.type = ParameterType::Length;
	return parameter;
}

Parameter automaticLength(std::string name, std::string label, std::string tooltip) {
	Parameter parameter = lengthParameter(std::move(name), -1, std::move(label), std::move(tooltip));
	parameter.range = Range();
	parameter.automatic = true;
	return parameter;
}

Parameter patchesParameter() {
	return enumeration(
		"patches", {"Connected components", "Face colour", "Texture islands", "Face quality"}, 0,
		"What separates panels",
		"What separates the patches: nothing but gaps, or also edges between faces of different colour, "
		"texture island or quality. Patches are the panels that are each made developable while they stay "
		"sewn together (Wang and Tang 2004, Section 3.1).");
}

Parameter weldDistanceParameter() {
	return lengthParameter(
		"weld_distance", 0, "Sewn together within",
		"Vertices at most this far apart are linked and move as one; 0 links only those with equal "
		"coordinates. So seams stay closed (Section 4.2).");
}

Parameter onlySelectedParameter() {
	return boolParameter("only_selected", false, "Only panels with a selection",
						 "Work on the patches that have a selected face; the others hold still.");
}

Parameter fixBoundaryParameter() {
	return boolParameter("fix_boundary", false, "Hold borders still",
						 "Vertices on the boundary of a patch stay where they are.");
}

Parameter fixSelectedParameter() {
	return boolParameter("fix_selected", false, "Hold selected vertices still",
						 "Selected vertices stay where they are.");
}

Parameter angleToleranceParameter() {
	return floatParameter(
		"angle_tolerance", 1e-4, {0}, "rad", "Angle left at a vertex",
		"A vertex whose angle defect is no larger than this counts as a developable point. The angle defect "
		"is the g of Eq. 5, and D of Eq. 2 is the share of such points; the paper's own setting is 0.01 rad. "
		"On fine meshes every vertex passes, so look at the total absolute curvature C too.");
}

Parameter mapParameter(Map defaultMap, std::vector<std::string> more) {
	std::vector<std::string> maps = {"Gaussian map",      "Angle defect",      "Gaussian curvature",
									 "Minimum curvature", "Maximum curvature", "Distance",
									 "Displacement"};
	maps.insert(maps.end(), more.begin(), more.end());
	return enumeration(
		"map", std::move(maps), static_cast<int>(defaultMap), "What is shown",
		"What is written to the vertex quality. It can be the squared angle defect (the paper's Gaussian map, "
		"Fig. 5), the angle defect g (Eq. 5), the Gaussian curvature (Eq. 1), the principal "
		"curvature of smaller or of larger absolute value (Fig. 10), the distance to the original "
		"surface (Fig. 8), or the distance moved.");
}

Parameter colorizeParameter() {
	Parameter parameter = boolParameter(
		"colorize", true, "Colour the vertices",
		"Colour the vertices by the map, in place of the colours that they have. Colours go from light yellow "
		"at 0 to dark violet, or where values have a sign from blue by light grey at 0 to red; the log says "
		"the range.");
	parameter.offWhenColoured = true;
	return parameter;
}

PatchOptions patchOptions(const ParameterValues& values) {
	const auto isOn = [&values](const char* name) { return values.has(name) && values.boolean(name); };
	PatchOptions options;
	options.seams = values.choice<SeamKind>("patches");
	options.weldDistance = values.number("weld_distance");
	options.onlySelected = isOn("only_selected");
	options.fixBoundary = isOn("fix_boundary");
	options.fixSelected = isOn("fix_selected");
	return options;
}

} // namespace developable::plugin
