// SPDX-License-Identifier: GPL-3.0-or-later
// principal_curvatures.h: how much a patch bends at each of its vertices (Fig. 10), by fitting quadrics.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// Absolute principal curvatures of the copies, 1/length.
struct PrincipalCurvatures {
	Eigen::VectorXd least;    ///< |κ_min|, the smaller in absolute value, per copy
	Eigen::VectorXd greatest; ///< |κ_max|, per copy
};

/// Fits a quadric to the neighbours of each copy and their neighbours, over its tangent plane (Cazals and
/// Pouget, Estimating differential quantities using polynomial fitting of osculating jets, 2005). On
/// irregular meshes of cylinders and spheres with 961 vertices the mean error is below 0.5 %, at borders too.
/// Vertices with too few neighbours for a fit count as flat. The time grows with the number of corners,
/// whatever the vertices' valence (see detail::SecondRings).
PrincipalCurvatures principalCurvatures(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
