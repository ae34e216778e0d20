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

std::vector<int> CurvatureGoal::borderOverlaps(const PatchAssembly& assembly,
											   const Positions& positions) const {
	const auto curved = unmetPatches(assembly, angleDefects(assembly, positions));
	const Eigen::VectorXd excess = borderAngles(assembly, positions).array() - 2 * pi;
	Eigen::ArrayXd greatest = Eigen::ArrayXd::Zero(assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		greatest[assembly.patchOfCopy[copy]] = std::max(greatest[assembly.patchOfCopy[copy]], excess[copy]);
	std::vector<int> overlaps(assembly.patchCount(), 0);
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int patch = assembly.patchOfCopy[copy];
		if (!curved[patch] && excess[copy] > 0 && excess[copy] >= std::min(greatest[patch], angleTolerance))
			++overlaps[patch];
	}
	return overlaps;
}

double CurvatureGoal::shareRemoved(double startCurvature, double curvature) const {
	const double whole = std::log(startCurvature / curvatureTolerance);
	const double done = std::log(startCurvature / std::max(curvature, curvatureTolerance));
	return whole > 0 ? std::clamp(done / whole, 0.0, 1.0) : 0;
}

bool better(const PatchAssembly& assembly, const Eigen::VectorXd& defects, const Eigen::VectorXd& others) {
	return detectFunction(defects) < detectFunction(others) && lessCurved(assembly, defects, others);
}

bool lessCurved(const PatchAssembly& assembly, const Eigen::VectorXd& defects,
				const Eigen::VectorXd& others) {
	if (holdsPlaces(assembly))
		return detectFunction(defects) < detectFunction(others);
	return totalAbsoluteCurvature(defects) < totalAbsoluteCurvature(others);
}

} // namespace developable::detail
