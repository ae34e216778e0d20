// SPDX-License-Identifier: GPL-3.0-or-later
// elastic_energy.h: the deformation energy E, a spring along every edge, and its gradient (Eq. 7, 11, 13).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable {

/// E = Σ over edges (length − original length)² (Eq. 7), length². An edge that two patches share counts in
/// each.
/// \param originalLengths  per edge, see edgeLengths
double elasticEnergy(const PatchAssembly& assembly, const Positions& positions,
					 const Eigen::VectorXd& originalLengths);

/// The gradient of E, 3 x places, length: 2(‖q_i q_j‖ − l0)(q_i − q_j)/‖q_i q_j‖ summed over the edges at all
/// linked copies. Eq. 11 and 13 print it with the opposite sign.
Positions elasticEnergyGradient(const PatchAssembly& assembly, const Positions& positions,
								const Eigen::VectorXd& originalLengths);

} // namespace developable
