// SPDX-License-Identifier: GPL-3.0-or-later
// curvature_goal.cpp: curvature by patch, and shapes compared.
#include "curvature_goal.h"

#include <cmath>

namespace developable::detail {

Eigen::ArrayXd patchCurvatures(const PatchAssembly& assembly, const Eigen::VectorXd& defects) {
	Eigen::ArrayXd curvatures = Eigen::ArrayXd::Zero(assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		curvatures[assembly.patchOfCopy[copy]] += std::abs(defects[copy]);
	return curvatures;
}

Eigen::Array<bool, Eigen::Dynamic, 1> CurvatureGoal::unmetPatches(const PatchAssembly& assembly,
																  const Eigen::VectorXd& defects) const {
	Eigen::ArrayXd greatest = Eigen::ArrayXd::Zero(assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		double& ofPatch = greatest[assembly.patchOfCopy[copy]];
		ofPatch = std::max(ofPatch, std::abs(defects[copy]));
	}
	return !(patchCurvatures(assembly, defects) <= curvatureTolerance && greatest <= angleTolerance);
}

double CurvatureGoal::shareRemoved(double startCurvature, double curvature) const {
	const double whole = std::log(startCurvature / curvatureTolerance);
	const double done = std::log(startCurvature / std::max(curvature, curvatureTolerance));
	return whole > 0 ? std::clamp(done / whole, 0.0, 1.0) : 0;
}

bool better(const PatchAssembly& assembly, const Eigen::VectorXd& defects, const Eigen::VectorXd& others,
			double share) {
	return detectFunction(defects) < share * detectFunction(others) &&
		   (holdsPlaces(assembly) || defects.cwiseAbs().sum() < others.cwiseAbs().sum());
}

} // namespace developable::detail
