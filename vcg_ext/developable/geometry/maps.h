// SPDX-License-Identifier: GPL-3.0-or-later
// maps.h: values per place that show where a shape is not developable, and how far it moved (Fig. 5 to 10).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The maps, in the order of the `map` enumeration.
enum class Map {
	GaussianMap,
	AngleDefect,
	GaussianCurvature,
	MinimumCurvature,
	MaximumCurvature,
	Distance,
	Displacement,
	ElasticEnergy, ///< of flattening, as all behind the next
	BendingRadius,
	EdgeStrain,
	Stretch,
	Compression
};

struct MapProperties {
	Map map;
	const char* title;
	const char* attribute; ///< name of the custom attribute that carries it
	const char* unit;
	int lengthPower; ///< of the unit: how values grow with the shape
	bool isSigned;
	bool isSquare; ///< of something that rounding makes an error in
};

/// Of all maps, in the order of Map.
inline constexpr MapProperties mapProperties[] = {
	{Map::GaussianMap, "Gaussian map", "gaussian_map", "rad²", 0, false, true},
	{Map::AngleDefect, "Angle defect", "angle_defect", "rad", 0, true, false},
	{Map::GaussianCurvature, "Gaussian curvature", "gaussian_curvature", "1/length²", -2, true, false},
	{Map::MinimumCurvature, "Minimum curvature", "kappa_min", "1/length", -1, false, false},
	{Map::MaximumCurvature, "Maximum curvature", "kappa_max", "1/length", -1, false, false},
	{Map::Distance, "Distance", "distance", "length", 1, false, false},
	{Map::Displacement, "Displacement", "displacement", "length", 1, false, false},
	{Map::ElasticEnergy, "Elastic energy", "elastic_energy", "length²", 2, false, true},
	{Map::BendingRadius, "Bending radius", "bending_radius", "length", 1, false, false},
	{Map::EdgeStrain, "Edge strain", "edge_strain", "1", 0, false, false},
	{Map::Stretch, "Stretch", "stretch", "1", 0, false, false},
	{Map::Compression, "Compression", "compression", "1", 0, false, false},
};

inline const MapProperties& propertiesOf(Map map) {
	return mapProperties[static_cast<int>(map)];
}

/// Where a place has several copies, the value of largest absolute value.
/// \param copyValues  per copy
/// \return            per place
Eigen::VectorXd largestCopies(const PatchAssembly& assembly, const Eigen::VectorXd& copyValues);

/// g per place, rad.
Eigen::VectorXd angleDefectMap(const PatchAssembly& assembly, const Positions& positions);

/// g² per place, rad²: the paper's Gaussian map (Fig. 5).
Eigen::VectorXd gaussianMap(const PatchAssembly& assembly, const Positions& positions);

/// κ per place (Eq. 1), 1/length².
Eigen::VectorXd gaussianCurvatureMap(const PatchAssembly& assembly, const Positions& positions);

/// Distance moved, per place.
Eigen::VectorXd displacementMap(const Positions& original, const Positions& positions);

} // namespace developable
