// SPDX-License-Identifier: GPL-3.0-or-later
// local_developability.cpp: the filter Local Developability (Section 5).
#include "../host.h"
#include "../optimize_layer.h"
#include "../shared_parameters.h"
#include "filters.h"

#include "developable/geometry/geometry.h"
#include "developable/local/local_method.h"

#include <type_traits>

namespace developable::plugin {

namespace {

LocalMethodOptions localOptions(const ParameterValues& values, int lengthExponent) {
	LocalMethodOptions options;
	options.angleTolerance = values.number("angle_tolerance");
	if (values.number("max_displacement") >= 0)
		options.maxDisplacement = inWorkingUnits(lengthExponent, values.number("max_displacement"));
	options.maxOperations = values.integer("max_operations");
	options.descent = values.boolean("descent");
	options.smoothing = values.number("smoothing");
	options.assemblingVertices = values.choice<AssemblingVertices>("assembling_vertices");
	options.avoidSelfIntersections = values.boolean("avoid_self_intersections");
	options.roundedToFloat = std::is_same_v<host::Scalar, float>;
	return options;
}

Results runLocal(FilterCall& call) {
	LocalMethodReport report;
	const Method method = [&](const PatchAssembly& assembly, Positions& positions, const Progress& progress) {
		const LocalMethodOptions options = localOptions(call.values, assembly.lengthExponent);
		return report = localMethod(assembly, positions, options, progress);
	};
	Optimized optimized = optimizeLayer(call, method);
	Results results = std::move(optimized.results);
	results.push_back({"set_aside", static_cast<int>(report.setAside), ""});
	results.push_back({"refused_moves", static_cast<int>(report.refusedMoves), ""});
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
	filter.shortName = "local";
	filter.filterClass = FilterClass::Smoothing;
	filter.change = Change::Positions;
	filter.help =
		"Makes each panel of the layer more <b>developable</b>, so that it comes nearer to what can be cut from a "
		"flat sheet, by moving one vertex at a time, the worst one first. Edges and seams of panels stay. It is "
		"fast, but rougher than Global Developability: begin with that.<br><br>"
		"For a first try leave everything as it is. If curvature is left, switch on <b>Only downhill</b> or "
		"let vertices <b>move</b> farther; if the surface wrinkles, set <b>Against wrinkles</b> to 0.01 to 0.1; if "
		"it is left along seams, let the <b>vertices on seams</b> move together; if layers of cloth lie close, "
		"<b>keep</b> them <b>from crossing</b>.<br><br>"
		"The log begins with what came of it. Closed surfaces must be cut first. There is no undo: <b>Restore "
		"Original Shape</b> takes it back. Help explains each setting, in the paper's terms.<br><br>"
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
			"max_displacement", "Move no farther than",
			"How far a vertex may move along its original normal; -1 means the mean edge length. Any "
			"negative number means that; it is the paper's difference tolerance (Section 5.2.1)."),
		intParameter("max_operations", 500000, 0, "Steps at most",
					 "The run ends after so many visits to a vertex at the latest. It is the paper's N_max "
					 "(Section 5.2.2)."),
		boolParameter(
			"descent", false, "Only downhill",
			"Halve each move until the vertex and its neighbours come nearer to developable, and set it aside "
			"if none does. Often gets farther with fewer wrinkles; the paper takes every move "
			"as it is (Section 5.1)."),
		floatParameter(
			"smoothing", 0, {0}, "rad²", "Against wrinkles",
			"How strongly the moves of neighbours are kept alike, against wrinkles; try 0.01 to 0.1. It is the "
			"weight of their mean square difference in mean edge lengths, best with 'Only downhill'; 0 is the "
			"paper's method (Section 7)."),
		enumeration(
			"assembling_vertices", {"Fixed", "Move together"}, 0, "Vertices on seams",
			"Whether vertices on seams stay fixed, or move together with all panels that meet there. The "
			"paper has them stay (Section 5.2.3); moving is best with 'Only downhill'."),
		boolParameter(
			"avoid_self_intersections", false, "Keep layers from crossing",
			"Shorten or refuse moves that would make the surface cut itself. Takes two to four times as long; "
			"the paper leaves it open (Section 7)."),
		mapParameter(Map::Displacement),
		colorizeParameter(),
	};
	filter.run = runLocal;
	return filter;
}

} // namespace developable::plugin
