// SPDX-License-Identifier: GPL-3.0-or-later
// elastic_energy.cpp: sums up what the spring of every edge has and does.
#include "elastic_energy.h"

namespace developable {

double elasticEnergy(const PatchAssembly& assembly, const Positions& positions,
					 const Eigen::VectorXd& originalLengths) {
	return (edgeLengths(assembly, positions) - originalLengths).squaredNorm();
}

Positions elasticEnergyGradient(const PatchAssembly& assembly, const Positions& positions,
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
