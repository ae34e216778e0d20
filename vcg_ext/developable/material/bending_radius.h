// SPDX-License-Identifier: GPL-3.0-or-later
// bending_radius.h: how tightly a sheet is bent, and how tightly it may be.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// The radius of the normal curvature across the rulings, 1 / |κ_max|, per place, of a place with several
/// copies the smallest; length. What is bent less than that counts as bent to ten diagonals of the object's
/// box. It is measured over the triangles round a vertex: what is folded more sharply than these tell counts
/// as folded over an edge's length.
/// \param positions  3 x places
Eigen::VectorXd bendingRadii(const PatchAssembly& assembly, const Positions& positions);

/// The smallest radius that a sheet bears without a set: its surface is strained by half its thickness over
/// the radius (Timoshenko and Gere, Mechanics of Materials, 1972, Section 5.2).
/// \param elasticStrain  of its surface, a share, positive
double leastBendingRadius(double thickness, double elasticStrain);

/// The share of the area, a third of each triangle to its corners, where the radius is below a limit.
double shareBelowRadius(const PatchAssembly& assembly, const Positions& positions,
						const Eigen::VectorXd& radii, double limit);

} // namespace developable
