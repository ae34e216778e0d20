// SPDX-License-Identifier: GPL-3.0-or-later
// maps.cpp: the maps of what geometry/ measures; a place shows the worst of its copies.
#include "maps.h"

#include "angle_defect.h"

#include <cmath>

namespace developable {

Eigen::VectorXd largestCopies(const PatchAssembly& assembly, const Eigen::VectorXd& copyValues) {
	Eigen::VectorXd values = Eigen::VectorXd::Zero(assembly.placeCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		double& value = values[assembly.placeOfCopy[copy]];
		if (std::abs(copyValues[copy]) > std::abs(value))
			value = copyValues[copy];
	}
	return values;
}

Eigen::VectorXd angleDefectMap(const PatchAssembly& assembly, const Positions& positions) {
	return largestCopies(assembly, angleDefects(assembly, positions));
}

Eigen::VectorXd gaussianMap(const PatchAssembly& assembly, const Positions& positions) {
	return angleDefectMap(assembly, positions).cwiseAbs2();
}

Eigen::VectorXd gaussianCurvatureMap(const PatchAssembly& assembly, const Positions& positions) {
	return largestCopies(assembly, gaussianCurvatures(assembly, positions));
}

Eigen::VectorXd displacementMap(const Positions& original, const Positions& positions) {
	return (positions - original).colwise().norm().transpose();
}

} // namespace developable
