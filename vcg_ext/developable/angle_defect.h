// SPDX-License-Identifier: GPL-3.0-or-later
// angle_defect.h: the angle defect g, its gradient, and what is summed from it (Sections 3.2, 3.3).
#pragma once

#include "detail/corner_geometry.h"
#include "detail/fan_angles.h"
#include "detail/triangle_kernel.h"
#include "patch_assembly.h"

namespace developable {

namespace detail {

/// The cotangents of all corners, 3 x triangles.
inline Eigen::Matrix3Xd cornerCotangents(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Matrix3Xd result(3, assembly.triangleCount());
	runWide(CotangentKernel{positions.data(), assembly.trianglePlaces.data(), assembly.triangleCount(),
							result.data()});
	return result;
}

} // namespace detail

/// Angle defect of every vertex copy (Eq. 5): 2π minus its corner angles inside a patch, 0 on the boundary.
/// \param positions  3 x places, any unit of length
/// \return           per copy, rad; not a number where a triangle has no area
inline Eigen::VectorXd angleDefects(const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd cotangents = detail::cornerCotangents(assembly, positions);
	Eigen::VectorXd defects(assembly.copyCount());
	detail::runWide(detail::FanKernel{cotangents.data(), assembly.corners.data(), assembly.cornerStart.data(),
									  assembly.copyCount(), assembly.copyInterior.data(), defects.data()});
	return defects;
}

/// The detect function G = Σ g² (Eq. 4), rad².
inline double detectFunction(const Eigen::VectorXd& defects) {
	return defects.squaredNorm();
}

/// The gradient of Σ weight · g over all copies with respect to the places, in closed form; linked copies add
/// up (Eq. 14). With weight = 2g it is the gradient of G. Weights of copies on a boundary must be 0. \return
/// 3 x places, rad/length times the weights' unit
inline Positions weightedDefectGradient(const PatchAssembly& assembly, const Positions& positions,
										const Eigen::VectorXd& weights) {
	Positions gradient = Positions::Zero(3, assembly.placeCount());
	detail::runWide(detail::AngleGradientKernel{positions.data(), assembly.trianglePlaces.data(),
												assembly.triangleCopies.data(), assembly.triangleCount(),
												weights.data(), gradient.data()});
	return gradient;
}

/// The gradient of the detect function G (Eq. 14) in closed form, 3 x places, rad²/length.
inline Positions detectFunctionGradient(const PatchAssembly& assembly, const Positions& positions,
										const Eigen::VectorXd& defects) {
	return weightedDefectGradient(assembly, positions, 2 * defects);
}

/// A third of the area of the triangles round each copy (Eq. 1 and 2), length².
inline Eigen::VectorXd copyAreas(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::VectorXd areas = Eigen::VectorXd::Zero(assembly.copyCount());
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto places = assembly.trianglePlaces.col(t);
		const detail::TriangleFrame frame(positions.col(places[0]), positions.col(places[1]),
										  positions.col(places[2]));
		for (const int copy : assembly.triangleCopies.col(t))
			areas[copy] += frame.normal.norm() / 6;
	}
	return areas;
}

/// Discrete Gaussian curvature κ of every copy (Eq. 1), 1/length².
inline Eigen::VectorXd gaussianCurvatures(const PatchAssembly& assembly, const Positions& positions) {
	return angleDefects(assembly, positions).cwiseQuotient(copyAreas(assembly, positions));
}

/// How developable a shape is.
struct Measures {
	double developability = 1;         ///< D (Eq. 2): share of area held by developable points, 0 to 1
	double detectFunction = 0;         ///< G (Eq. 4), rad²
	double maxAngleDefect = 0;         ///< largest absolute g, rad
	double totalAbsoluteCurvature = 0; ///< C = Σ abs(g), rad
};

/// Measures a shape. A copy with an angle defect of at most angleTolerance (rad) is a developable point.
inline Measures measure(const PatchAssembly& assembly, const Positions& positions, double angleTolerance) {
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	const Eigen::VectorXd areas = copyAreas(assembly, positions);
	Measures measures;
	measures.detectFunction = detectFunction(defects);
	measures.maxAngleDefect = defects.size() > 0 ? defects.cwiseAbs().maxCoeff() : 0;
	measures.totalAbsoluteCurvature = defects.cwiseAbs().sum();
	const double developable = (defects.array().abs() <= angleTolerance).select(areas.array(), 0).sum();
	// Equal sums in a different order may differ in the last bit; all developable means exactly 1.
	if (measures.maxAngleDefect > angleTolerance)
		measures.developability = developable / areas.sum();
	return measures;
}

} // namespace developable
