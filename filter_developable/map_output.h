// SPDX-License-Identifier: GPL-3.0-or-later
// map_output.h: computes the map that the user chose and shows it on the layer.
#pragma once

#include "filter_call.h"

#include "developable/geometry/geometry.h"

namespace developable::plugin {

/// The map that the call asks for.
Map chosenMap(const ParameterValues& values);

/// A map of the shape that `positions` make, per place. Distance and Displacement are measured from
/// `original`. \param original  3 x places; the original surface has the same triangles
Eigen::VectorXd mapValues(Map map, const PatchAssembly& assembly, const Positions& positions,
						  const Positions& original);

/// Writes a map to its custom attribute. \param values  per place, in the assembly's unit
void writeMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values);

/// Writes a map, in the assembly's unit too, to the vertex quality and, where that is asked for, the colours,
/// and logs its range.
void showMap(FilterCall& call, const PatchAssembly& assembly, Map map, const Eigen::VectorXd& values);

} // namespace developable::plugin
