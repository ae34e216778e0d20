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

/// Estimates principal curvatures by vcglib's quadric fitting. Of its estimators it is the one that
/// converges: on irregular meshes of cylinders and spheres with 961 vertices its mean error is below 0.5 %,
/// at borders too, where PrincipalDirections (Taubin) is off by a quarter and more and
/// PrincipalDirectionsNormalCycle is not scaled to curvatures at all. Vertices with too few neighbours for a
/// fit count as flat.
PrincipalCurvatures principalCurvatures(const PatchAssembly& assembly, const Positions& positions);

} // namespace developable
