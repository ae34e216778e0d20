// SPDX-License-Identifier: GPL-3.0-or-later
// angle_defect.cpp: runs the kernels over all triangles and all vertex copies, and sums up what they give.
#include "angle_defect.h"

#include "corner_geometry.h"
#include "fan_kernel.h"
#include "triangle_kernel.h"

namespace developable {

namespace {

/// 2π minus the angles at every copy.
Eigen::VectorXd fullTurnMinusAngles(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly, positions);
	Eigen::VectorXd defects(assembly.copyCount());
	detail::runWide(detail::FanKernel{cotangents.data(), assembly.corners.data(), assembly.cornerStart.data(),
									  assembly.copyCount(), defects.data()});
	return defects;
}

auto isInterior(const PatchAssembly& assembly) {
	return Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>(assembly.copyInterior.data(),
																   assembly.copyCount()) != 0;
}

} // namespace

Eigen::Matrix3Xd cornerCotangents(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd result(3, assembly.triangleCount());
	detail::runWide(detail::CotangentKernel{positions.data(), assembly.trianglePlaces.data(),
											assembly.triangleCount(), result.data()});
	return result;
}

Eigen::VectorXd angleDefects(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::ArrayXd defects = fullTurnMinusAngles(assembly, positions);
	return isInterior(assembly).select(defects, 0);
}

Eigen::VectorXd borderAngles(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::ArrayXd defects = fullTurnMinusAngles(assembly, positions);
	return isInterior(assembly).select(0, 2 * pi - defects);
}

Eigen::VectorXd flatDefects(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::ArrayXd defects = fullTurnMinusAngles(assembly, positions);
	return isInterior(assembly).select(defects, defects.min(0));
}

double detectFunction(const Eigen::VectorXd& defects) {
	return defects.squaredNorm();
}

double totalAbsoluteCurvature(const Eigen::VectorXd& defects) {
	return defects.cwiseAbs().sum();
}

double largestAngleDefect(const Eigen::VectorXd& defects) {
	return defects.size() > 0 ? defects.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() : 0;
}

Positions weightedDefectGradient(const PatchAssembly& assembly, const Positions& positions,
								 const Eigen::VectorXd& weights) {
	Positions gradient = Positions::Zero(3, assembly.placeCount());
	detail::runWide(detail::AngleGradientKernel{positions.data(), assembly.trianglePlaces.data(),
												assembly.triangleCopies.data(), assembly.triangleCount(),
												weights.data(), gradient.data()});
	return gradient;
}

Positions detectFunctionGradient(const PatchAssembly& assembly, const Positions& positions,
								 const Eigen::VectorXd& defects) {
	return weightedDefectGradient(assembly, positions, 2 * defects);
}

Eigen::VectorXd copyAreas(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd areas = Eigen::VectorXd::Zero(assembly.copyCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const TriangleFrame frame = triangleFrame(positions, assembly.trianglePlaces.col(t));
		for (const int copy : assembly.triangleCopies.col(t))
			areas[copy] += frame.normal.norm() / 6;
	}
	return areas;
}

Eigen::VectorXd gaussianCurvatures(const PatchAssembly& assembly, const Positions& positions) {
	return angleDefects(assembly, positions).cwiseQuotient(copyAreas(assembly, positions));
}

Measures measure(const PatchAssembly& assembly, const Positions& positions, double angleTolerance) {
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	const Eigen::VectorXd areas = copyAreas(assembly, positions);
	Measures measures;
	measures.detectFunction = detectFunction(defects);
	measures.maxAngleDefect = largestAngleDefect(defects);
	measures.totalAbsoluteCurvature = totalAbsoluteCurvature(defects);
	const double developable = (defects.array().abs() <= angleTolerance).select(areas.array(), 0).sum();
	// Equal sums in a different order may differ in the last bit; all developable means exactly 1.
	if (!(measures.maxAngleDefect <= angleTolerance))
		measures.developability = developable / areas.sum();
	return measures;
}

} // namespace developable
