// SPDX-License-Identifier: GPL-3.0-or-later
// materials.h: the table of materials, materials.json, and what a filter's parameters ask of a material.
#pragma once

#include "filter_description.h"

#include "developable/material/material.h"

namespace developable::plugin {

/// One entry of the table.
struct Material {
	std::string name;
	StrainBounds bounds;
	double elasticStrain = 0; ///< of its surface when it is bent without a set, a share; 0: not known
	double thickness = 0;     ///< of the stuff that the numbers are of, mm; 0: any
	double smoothness = 0;    ///< that suits it; 0: the filter's default
	std::string source;
};

/// The file, as it was when the plugin was built.
const char* materialsText();

/// In the order of the `material` enumeration.
const std::vector<Material>& materials();

/// `thickness`.
Parameter thicknessParameter();

/// `material`, `allowed_stretch`, `allowed_compression` and `grain`.
std::vector<Parameter> materialParameters();

/// The environment variable that holds an entry of a user's own, in the table's form; it stands for Custom.
constexpr const char* ownMaterialVariable = "DEVELOPABLE_MATERIAL";

/// The environment variable that holds a direction of a user's own, [x, y, z]; it stands for the longest
/// seam.
constexpr const char* ownGrainVariable = "DEVELOPABLE_GRAIN";

/// \throws InvalidParameter  when the user's own is none
Grain chosenGrain(const ParameterValues& values);

/// \throws InvalidParameter  when the user's own is none
Material chosenMaterial(const ParameterValues& values);

/// The material's bounds, or those that were asked for in place of them.
/// \throws InvalidParameter
StrainBounds strainBounds(const ParameterValues& values);

/// The smallest radius that a sheet of the chosen thickness and material bears, in the mesh's unit; 0 where
/// either is not known.
double smallestRadius(const ParameterValues& values);

/// The parameter `smoothness`, or what suits the material where that is at its default or the filter has
/// none.
double chosenSmoothness(const ParameterValues& values);

} // namespace developable::plugin
