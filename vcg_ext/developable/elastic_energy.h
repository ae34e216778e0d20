// SPDX-License-Identifier: GPL-3.0-or-later
// elastic_energy.h: the deformation energy E, a spring along every edge, and its gradient (Eq. 7, 11, 13).
#pragma once

#include "patch_assembly.h"

namespace developable {

/// E = Σ over edges (length − original length)² (Eq. 7), length². An edge that two patches share counts in
/// each. \param originalLengths  per edge, see edgeLengths
inline double elasticEnergy(const PatchAssembly& assembly, const Positions& positions,
							const Eigen::VectorXd& originalLengths) {
	return (edgeLengths(assembly, positions) - originalLengths).squaredNorm();
}

/// The gradient of E, 3 x places, length: 2(‖q_i q_j‖ − l0)(q_i − q_j)/‖q_i q_j‖ summed over the edges at all
/// linked copies. Eq. 11 and 13 print it with the opposite sign.
inline Positions elasticEnergyGradient(const PatchAssembly& assembly, const Positions& positions,
									   const Eigen::VectorXd& originalLengths) {
	Positions gradient = Positions::Zero(3, assembly.placeCount());
	for (int edge = 0; edge < assembly.edgeCount(); ++edge) {
		const int start = assembly.edgePlaces(0, edge), end = assembly.edgePlaces(1, edge);
		const Eigen::Vector3d along = positions.col(start) - positions.col(end);
		const double length = along.norm();
		if (length == 0)
			continue;
		const Eigen::Vector3d pull = 2 * (1 - originalLengths[edge] / length) * along;
		gradient.col(start) += pull;
		gradient.col(end) -= pull;
	}
	return gradient;
}

} // namespace developable
