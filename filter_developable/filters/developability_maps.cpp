// SPDX-License-Identifier: GPL-3.0-or-later
// developability_maps.cpp: the filter Developability Maps (Sections 3 and 6).
#include "../layer.h"
#include "../map_output.h"
#include "../reference_shape.h"
#include "../shared_parameters.h"
#include "filters.h"

#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"
#include "developable/vcg_mesh/vcg_mesh.h"

namespace developable::plugin {

namespace {

struct ComputedMap {
	Map map;
	Eigen::VectorXd values; ///< per place
};

/// Of laying the patches flat, per place (Fig. 1); nothing when the user asked for a stop.
std::optional<Eigen::VectorXd> elasticEnergyMap(const PatchAssembly& assembly, const Progress& progress) {
	const FlatPatterns patterns =
		flattenPatches(assembly, assembly.originalPositions, FlattenOptions(), progress);
	if (patterns.report.stopped)
		return std::nullopt;
	return largestAtPlaces(assembly, patterns, patterns.elasticEnergy);
}

/// All maps that can be made, none when the user asked for a stop. Flattening takes longest and refuses some
/// shapes, so it waits until it is chosen.
std::vector<ComputedMap> computeMaps(const PatchAssembly& assembly,
									 const std::optional<ReferenceShape>& reference, Map chosen,
									 const Progress& progress) {
	const Positions& positions = assembly.originalPositions;
	std::vector<ComputedMap> maps;
	for (const Map map : {Map::GaussianMap, Map::AngleDefect, Map::GaussianCurvature, Map::MinimumCurvature,
						  Map::MaximumCurvature, Map::BendingRadius})
		maps.push_back({map, mapValues(map, assembly, positions, positions)});
	if (chosen == Map::ElasticEnergy) {
		const std::optional<Eigen::VectorXd> energies = elasticEnergyMap(assembly, progress);
		if (!energies)
			return {};
		maps.push_back({chosen, *energies});
	}
	if (reference)
		maps.push_back(
			{Map::Distance, distancesToSurface(positions, reference->vertices, reference->triangles)});
	if (reference && reference->places)
		maps.push_back({Map::Displacement, displacementMap(*reference->places, positions)});
	return maps;
}

[[noreturn]] void refuseWithoutReference(Map map, bool hasReference) {
	const std::string title = propertiesOf(map).title;
	if (hasReference)
		throw MissingAttribute(
			"The map '" + title +
			"' needs a reference with as many vertices as this mesh: choose such a layer as "
			"'reference', or the map 'Distance'.");
	throw MissingAttribute(
		"The map '" + title +
		"' needs the shape before an optimisation, and this mesh has no attribute "
		"'original_position': run Global or Local Developability first, or choose another layer "
		"as 'reference'. The attribute is lost when a mesh is saved and loaded again, as MeshLab reads "
		"no attributes from files: then load the original too and choose it as 'reference'.");
}

const ComputedMap& find(const std::vector<ComputedMap>& maps, Map chosen, bool hasReference) {
	for (const ComputedMap& computed : maps)
		if (computed.map == chosen)
			return computed;
	refuseWithoutReference(chosen, hasReference);
}

Results measures(const PatchAssembly& assembly, double angleTolerance) {
	const Measures measured = measure(assembly, assembly.originalPositions, angleTolerance);
	return {
		{"patches", assembly.patchCount(), ""},
		{"assembling_vertices", assembly.assemblingPlaceCount(), ""},
		{"interior_vertices", assembly.interiorCopyCount(), ""},
		{"developability", measured.developability, ""},
		{"detect_function", measured.detectFunction, ""},
		{"max_angle_defect", measured.maxAngleDefect, ""},
		{"total_absolute_curvature", measured.totalAbsoluteCurvature, ""},
	};
}

Results runMaps(FilterCall& call) {
	const Map chosen = chosenMap(call.values);
	const PatchAssembly assembly = readPatches(call.layer.mesh(), patchOptions(call.values));
	const std::optional<ReferenceShape> reference = referenceShape(call, assembly);
	const std::vector<ComputedMap> maps = computeMaps(assembly, reference, chosen, call.progress);
	Results results = measures(assembly, call.values.number("angle_tolerance"));
	if (maps.empty()) {
		call.log("stopped by the user: nothing was changed");
		return results;
	}
	call.verdict(
		filledIn("{total_absolute_curvature} rad of total absolute curvature; the largest angle defect "
				 "is {max_angle_defect} rad",
				 results));
	const ComputedMap& shown = find(maps, chosen, reference.has_value());
	for (const ComputedMap& computed : maps)
		writeMap(call, assembly, computed.map, computed.values);
	showMap(call, assembly, shown.map, shown.values);
	return results;
}

Parameter referenceParameter() {
	Parameter parameter;
	parameter.name = "reference";
	parameter.type = ParameterType::Mesh;
	parameter.label = "Compared with";
	parameter.tooltip =
		"The layer that the maps Distance and Displacement are measured from. The current layer means the "
		"shape that its last optimisation started from; see Fig. 8.";
	return parameter;
}

} // namespace

FilterDescription developabilityMaps() {
	FilterDescription filter;
	filter.name = "Developability Maps";
	filter.pythonName = "compute_scalar_by_developability_per_vertex";
	filter.shortName = "maps";
	filter.filterClass = FilterClass::Quality;
	filter.change = Change::Scalars;
	filter.help =
		"Shows in colours where the panels of a layer can't be laid flat without strain, that is, where they are "
		"not <b>developable</b>, and how far an optimisation has moved them. Nothing moves. The chosen map goes "
		"to the vertex quality, all maps but the elastic energy go to custom attributes; at a seam the largest "
		"value is shown. Help says what each map is.<br><br>"
		"The log begins with C, the total absolute curvature: 0 where all panels can be laid flat, and the same "
		"however fine the mesh is. D, the share of the area that is developable, grows with finer meshes.<br><br>"
		"See: <i>C. C. L. Wang, K. Tang</i>, <b>Achieving developability of a polygonal surface by minimum "
		"deformation: a study of global and local optimization approaches</b>, The Visual Computer 20, 2004, "
		"Sections 3 and 6.";
	filter.parameters = {
		patchesParameter(),        weldDistanceParameter(),
		angleToleranceParameter(), mapParameter(Map::GaussianMap, {"Elastic energy", "Bending radius"}),
		referenceParameter(),      colorizeParameter(),
	};
	filter.run = runMaps;
	return filter;
}

} // namespace developable::plugin
