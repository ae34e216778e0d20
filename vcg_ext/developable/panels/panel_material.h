// SPDX-License-Identifier: GPL-3.0-or-later
// panel_material.h: what the panels are made of, and whether one that may be strained holds.
#pragma once

#include "developable/material/material.h"
#include "developable/mesh/mesh.h"

namespace developable {

/// What panels bear between their flat patterns and the shape. Without any strain they have to become
/// developable.
struct PanelMaterial {
	StrainBounds bounds = {};
	Grain grain = Grain::LongestSeam; ///< of directed bounds
	double smoothness = 3e-6;         ///< as in BoundedStrainOptions
};

namespace detail {

/// What a panel's pattern of least squares lets expect.
enum class Outlook {
	Hopeless,     ///< it overlaps itself, or is strained by more than can be borne and moved away
	MostlyMoves,  ///< the material bears a small part of its strain: as without any it will hold or not
	MostlyStrains ///< or a large part
};

/// A round cap of radius r that rises by h is strained by some h / (6 r) on average: so much less is left
/// when places move.
Outlook outlookOf(const PatchAssembly& panel, const PanelMaterial& material, double maxDisplacement);

struct PatternVerdict {
	double beyondBounds = 0; ///< by how much a strain is beyond its bound, at most
	bool usable = true;      ///< it neither overlaps itself, nor had to be cut, nor flips
	Eigen::Vector3d worstPoint = Eigen::Vector3d::Zero(); ///< where on the model that is

	bool holds() const { return usable && beyondBounds <= patternTolerance; }
};

/// How far a shape within the bounds is looked for.
struct BoundedSearch {
	double maxDisplacement = -1; ///< as in BoundedStrainOptions; so is the next
	double meanOnWay = 0;
	bool brief = false; ///< whether to give up early
};

constexpr double workOnStrain = 300; ///< of bringWithinBounds on a triangle, in units of WorkBudget

/// Moves places to the nearest shape whose patterns are within the bounds, as Global Developability will.
/// \return  one for each patch, laid flat within the bounds
std::vector<PatternVerdict> bringWithinBounds(const PatchAssembly& assembly, Positions& positions,
											  const PanelMaterial& material, const BoundedSearch& search,
											  const Progress& progress);

} // namespace detail

} // namespace developable
