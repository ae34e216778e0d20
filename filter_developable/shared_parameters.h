// SPDX-License-Identifier: GPL-3.0-or-later
// shared_parameters.h: the parameters that mean the same in several filters.
#pragma once

#include "filter_description.h"

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

namespace developable::plugin {

Parameter boolParameter(std::string name, bool defaultValue, std::string label, std::string tooltip);
Parameter intParameter(std::string name, int defaultValue, int minimum, std::string label,
					   std::string tooltip);
/// \param unit  empty: none
Parameter floatParameter(std::string name, double defaultValue, Range range, std::string unit,
						 std::string label, std::string tooltip);
Parameter enumeration(std::string name, std::vector<std::string> values, int defaultIndex, std::string label,
					  std::string tooltip);

/// A length of 0 or more in the mesh's unit.
Parameter lengthParameter(std::string name, double defaultValue, std::string label, std::string tooltip);
/// A length whose default, -1 as any negative one, leaves the choice to the filter.
Parameter automaticLength(std::string name, std::string label, std::string tooltip);

Parameter patchesParameter();
Parameter weldDistanceParameter();
Parameter onlySelectedParameter();
Parameter fixBoundaryParameter();
Parameter fixSelectedParameter();
Parameter angleToleranceParameter();
/// The seven maps of shapes, then `more`; the default is one of the seven.
Parameter mapParameter(Map defaultMap, std::vector<std::string> more = {});
Parameter colorizeParameter();

/// What those of the parameters above that the filter has ask for.
PatchOptions patchOptions(const ParameterValues& values);

} // namespace developable::plugin
