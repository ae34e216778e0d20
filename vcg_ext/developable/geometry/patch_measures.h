// SPDX-License-Identifier: GPL-3.0-or-later
// patch_measures.h: how developable each patch is, and how far it moved.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// One patch of a shape.
struct PatchMeasures {
	int faces = 0;
	double curvature = 0;        ///< C = Σ abs(g), rad
	double maxAngleDefect = 0;   ///< largest absolute g, rad
	Eigen::Vector3d worstPoint;  ///< where that is; of several the first copy
	double meanDisplacement = 0; ///< from the original, over the patch's vertex copies, length
	double maxDisplacement = 0;
};

/// \param positions  3 x places
/// \return           per patch
std::vector<PatchMeasures> measurePatches(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
