// SPDX-License-Identifier: GPL-3.0-or-later
// bending_radius.cpp: radii from principal curvatures, and areas by radius.
#include "bending_radius.h"

#include "developable/geometry/geometry.h"

namespace developable {

Eigen::VectorXd bendingRadii(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::VectorXd curvatures =
		largestCopies(assembly, principalCurvatures(assembly, positions).greatest);
	const double least = 1 / (10 * boxDiagonal(positions));
	return curvatures.cwiseMax(least).cwiseInverse();
}

double leastBendingRadius(double thickness, double elasticStrain) {
	return thickness / (2 * elasticStrain);
}

double shareBelowRadius(const PatchAssembly& assembly, const Positions& positions,
						const Eigen::VectorXd& radii, double limit) {
	double below = 0, whole = 0;
	for (const auto& places : assembly.trianglePlaces.colwise()) {
		const double area = triangleFrame(positions, places).normal.norm() / 6;
		for (const int place : places)
			below += radii[place] < limit ? area : 0;
		whole += 3 * area;
	}
	return below / whole;
}

} // namespace developable
