// SPDX-License-Identifier: GPL-3.0-or-later
// local_developability.cpp: the filter Local Developability (Section 5).
#include "../optimize_layer.h"
#include "../shared_parameters.h"
#include "filters.h"

#include "developable/local_method.h"
#include "developable/roughness.h"

namespace developable::plugin {

namespace {

/// In the order of the `assembling_vertices` enumeration.
enum class AssemblingVertices { Fixed, MoveTogether };

void refuseOptionsNotYet(const ParameterValues& values) {
	if (values.boolean("descent"))
		refuseNotYet("The parameter 'descent'", "false");
	if (values.number("smoothing") != 0)
		refuseNotYet("The parameter 'smoothing'", "0");
	if (values.choice<AssemblingVertices>("assembling_vertices") == AssemblingVertices::MoveTogether)
		refuseNotYet("The value 'Move together' of 'assembling_vertices'", "'Fixed'");
	if (values.boolean("avoid_self_intersections"))
		refuseNotYet("The parameter 'avoid_self_intersections'", "false");
}

LocalMethodOptions localOptions(const ParameterValues& values) {
	LocalMethodOptions options;
	options.angleTolerance = values.number("angle_tolerance");
	if (values.number("max_displacement") >= 0)
		options.maxDisplacement = values.number("max_displacement");
	options.maxOperations = values.integer("max_operations");
	return options;
}

Results run(FilterCall& call) {
	refuseOptionsNotYet(call.values);
	const LocalMethodOptions options = localOptions(call.values);
	LocalMethodReport report;
	const Method method = [&](const PatchAssembly& assembly, Positions& positions, const Progress& progress) {
		return report = localMethod(assembly, positions, options, progress);
	};
	Optimized optimized = optimizeLayer(call, method);
	Results results = std::move(optimized.results);
	results.push_back({"set_aside", static_cast<int>(report.setAside), ""});
	results.push_back({"refused_moves", 0, ""}); // moves are refused for self-intersections only
	results.push_back(
		{"roughness_before", roughness(optimized.assembly, optimized.assembly.originalPositions), ""});
	results.push_back({"roughness_after", roughness(optimized.assembly, optimized.positions), ""});
	return results;
}

} // namespace

FilterDescription localDevelopability() {
	FilterDescription filter;
	filter.name = "Local Developability";
	filter.pythonName = "apply_coord_local_developability";
	filter.filterClass = FilterClass::Smoothing;
	filter.change = Change::Positions;
	filter.help =
		"Makes each panel of the layer more <b>developable</b> by moving one vertex at a time along its "
		"original "
		"normal, the one with the largest angle defect first. Vertices on boundaries and seams stay, and no "
		"vertex "
		"moves farther than the largest displacement: a larger one gives more developability and more "
		"wrinkles "
		"(Fig. 9 and 10). It is fast, but rougher than Global Developability.<br><br>"
		"The log says how developable the surface was and is: D, the share of its area that is developable, "
		"G, the "
		"sum of squared angle defects, and C, the total absolute curvature, which unlike D does not depend "
		"on how "
		"fine the mesh is. Closed surfaces must be cut first.<br><br>"
		"See: <i>C. C. L. Wang, K. Tang</i>, <b>Achieving developability of a polygonal surface by minimum "
		"deformation: a study of global and local optimization approaches</b>, The Visual Computer 20, 2004, "
		"Section 5.";
	filter.parameters = {
		patchesParameter(),
		weldDistanceParameter(),
		onlySelectedParameter(),
		fixSelectedParameter(),
		angleToleranceParameter(),
		automaticLength(
			"max_displacement", "Largest displacement",
			"How far a vertex may move along its original normal, the paper's difference tolerance "
			"(Section 5.2.1); -1, as any negative number, means the mean edge length."),
		intParameter("max_operations", 500000, 0, "Largest number of operations",
					 "The run ends after so many visits to a vertex at the latest; the paper's N_max "
					 "(Section 5.2.2)."),
		boolParameter(
			"descent", false, "Only downhill",
			"Halve each step until the vertex and its neighbours come nearer to developable; the paper takes "
			"every step as it is (Section 5.1). Does not work yet in this version."),
		floatParameter(
			"smoothing", 0, 0, "Smoothing",
			"How strongly the moves of neighbours are kept alike, against wrinkles; 0 is the paper's method, "
			"which has no such term (Section 7). Does not work yet in this version."),
		enumeration(
			"assembling_vertices", {"Fixed", "Move together"}, 0, "Assembling vertices",
			"Whether vertices on seams stay fixed, as in the paper (Section 5.2.3), or move together; the "
			"latter does not work yet in this version."),
		boolParameter(
			"avoid_self_intersections", false, "Avoid self-intersections",
			"Shorten or refuse moves that would make the surface cut itself, which the paper leaves open "
			"(Section 7). Does not work yet in this version."),
		mapParameter(),
		colorizeParameter(),
	};
	filter.run = run;
	return filter;
}

} // namespace developable::plugin
