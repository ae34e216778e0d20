// SPDX-License-Identifier: GPL-3.0-or-later
// map_output.cpp: from the choice of a map to quality, colours, custom attribute and a line in the log.
#include "map_output.h"

#include "colour_map.h"
#include "layer.h"
#include "results.h"
#include "shared_parameters.h"
#include "vertex_data.h"

#include "developable/geometry/geometry.h"
#include "developable/material/material.h"

#include <cmath>

namespace developable::plugin {

namespace {

/// What of a map comes from rounding and from where an optimisation stopped, not from the shape. Without it
/// the colours of a developable shape would show nothing else.
///
/// \param diagonal  of the layer's box
double noiseOf(const MapProperties& properties, double diagonal) {
	constexpr double ofLengths = 1e-5;
	constexpr double ofAngles = 1e-4; // as much as a developable point may have left
	const double share = properties.lengthPower == 0 ? ofAngles : ofLengths;
	const double noise = share * std::pow(diagonal > 0 ? diagonal : 1, properties.lengthPower);
	return properties.isSquare ? share * noise : noise;
}

} // namespace

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
	case Map::BendingRadius:
		return bendingRadii(assembly, positions);
	default:
		return Eigen::VectorXd::Zero(assembly.placeCount());
	}
}

void writeMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values) {
	writeScalarAttribute(call.layer.mesh(), propertiesOf(map).attribute, assembly,
						 inMeshUnits(assembly.lengthExponent, values, propertiesOf(map).lengthPower));
}

void showMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values) {
	const MapProperties& properties = propertiesOf(map);
	call.layer.enableVertexQuality();
	const auto inUnits = [&](double value) {
		return inMeshUnits(assembly.lengthExponent, value, properties.lengthPower);
	};
	writeQuality(call.layer.mesh(), assembly, values.unaryExpr(inUnits));
	call.log(std::string("vertex quality: ") + properties.title + " [" + properties.unit + "], " +
			 formatted(inUnits(values.minCoeff()), 4) + " to " + formatted(inUnits(values.maxCoeff()), 4));
	if (!call.values.boolean("colorize"))
		return;
	const ColourRange range =
		colourRange(values, properties.isSigned,
					noiseOf(properties, inWorkingUnits(assembly.lengthExponent, call.layer.diagonal())));
	call.layer.enableVertexColours();
	writeColours(call.layer.mesh(), assembly, mapColours(values, range));
	call.log("vertex colours: " +
			 describe(range, formatted(inUnits(range.high), 4) + " " + properties.unit, values));
}

} // namespace developable::plugin
