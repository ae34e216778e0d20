// SPDX-License-Identifier: GPL-3.0-or-later
// penalty_function.cpp: value and gradient of the penalty function.
#include "penalty_function.h"

#include "developable/geometry/geometry.h"

namespace developable::detail {

PenaltyFunction::PenaltyFunction(const PatchAssembly& assembly)
	: assembly_(assembly), originalLengths_(edgeLengths(assembly, assembly.originalPositions)) {}

void PenaltyFunction::weighFor(double detectFunctionAtStart) {
	const double meanSquare = originalLengths_.squaredNorm() / originalLengths_.size();
	penalty_ = meanSquare / (detectFunctionAtStart * detectFunctionAtStart);
}

double PenaltyFunction::value(const Positions& positions) const {
	const double g = detectFunction(angleDefects(assembly_, positions));
	return elasticEnergy(assembly_, positions, originalLengths_) + penalty_ / 2 * g * g;
}

Positions PenaltyFunction::gradient(const Positions& positions) const {
	const Eigen::VectorXd defects = angleDefects(assembly_, positions);
	Positions result = elasticEnergyGradient(assembly_, positions, originalLengths_);
	result += weightedDefectGradient(assembly_, positions, 2 * penalty_ * detectFunction(defects) * defects);
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (assembly_.placeFixed[place])
			result.col(place).setZero();
	return result;
}

} // namespace developable::detail
