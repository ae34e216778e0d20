// SPDX-License-Identifier: GPL-3.0-or-later
// map_output.cpp: from the choice of a map to quality, colours, custom attribute and a line in the log.
#include "map_output.h"

#include "colour_map.h"
#include "layer.h"
#include "results.h"
#include "shared_parameters.h"
#include "vertex_data.h"

#include "developable/principal_curvatures.h"
#include "developable/surface_distance.h"

namespace developable::plugin {

Map chosenMap(const ParameterValues& values) {
	return values.choice<Map>("map");
}

Eigen::VectorXd mapValues(Map map, const PatchAssembly& assembly, const Positions& positions,
						  const Positions& original) {
	switch (map) {
	case Map::GaussianMap:
		return gaussianMap(assembly, positions);
	case Map::AngleDefect:
		return angleDefectMap(assembly, positions);
	case Map::GaussianCurvature:
		return gaussianCurvatureMap(assembly, positions);
	case Map::MinimumCurvature:
		return largestCopies(assembly, principalCurvatures(assembly, positions).least);
	case Map::MaximumCurvature:
		return largestCopies(assembly, principalCurvatures(assembly, positions).greatest);
	case Map::Distance:
		return distancesToSurface(positions, original, assembly.trianglePlaces);
	case Map::Displacement:
		return displacementMap(original, positions);
	default:
		return Eigen::VectorXd::Zero(assembly.placeCount());
	}
}

void writeMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values) {
	writeScalarAttribute(call.layer.mesh(), propertiesOf(map).attribute, assembly, values);
}

void showMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values) {
	const MapProperties& properties = propertiesOf(map);
	call.layer.enableVertexQuality();
	writeQuality(call.layer.mesh(), assembly, values);
	call.log(std::string("vertex quality: ") + properties.title + " [" + properties.unit + "], " +
			 formatted(values.minCoeff()) + " to " + formatted(values.maxCoeff()));
	if (!call.values.boolean("colorize"))
		return;
	const ColourRange range = colourRange(values, properties.isSigned);
	call.layer.enableVertexColours();
	writeColours(call.layer.mesh(), assembly, mapColours(values, range));
	call.log("vertex colours: blue at " + formatted(range.low) + ", red at " + formatted(range.high));
}

} // namespace developable::plugin
