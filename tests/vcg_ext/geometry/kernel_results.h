// SPDX-License-Identifier: GPL-3.0-or-later
// kernel_results.h: what the kernels give with a chosen number of numbers at a time.
#pragma once

#include "developable/geometry/fan_kernel.h"
#include "developable/geometry/geometry.h"
#include "developable/geometry/triangle_kernel.h"

namespace developable::test {

struct KernelResults {
	Eigen::Matrix3Xd cotangents; ///< of all corners, 3 x triangles
	Eigen::Matrix3Xd normals;    ///< 3 x triangles
	Eigen::VectorXd defects;     ///< per copy, on borders, too
	Positions gradient;          ///< of Σ weight · g with the defects as weights, 3 x places
};

/// The gradient is the one that the defects have as weights.
template <class Number>
KernelResults kernelResults(const PatchAssembly& assembly) {
	const int *places = assembly.trianglePlaces.data(), triangles = assembly.triangleCount();
	const double* positions = assembly.originalPositions.data();
	KernelResults results{Eigen::Matrix3Xd(3, triangles), Eigen::Matrix3Xd(3, triangles),
						  Eigen::VectorXd(assembly.copyCount()), Positions::Zero(3, assembly.placeCount())};
	detail::CotangentKernel{positions, places, triangles, results.cotangents.data()}.run<Number>();
	detail::NormalKernel{positions, places, triangles, results.normals.data()}.run<Number>();
	detail::FanKernel{results.cotangents.data(), assembly.corners.data(), assembly.cornerStart.data(),
					  assembly.copyCount(), results.defects.data()}
		.run<Number>();
	detail::AngleGradientKernel{positions,
								places,
								assembly.triangleCopies.data(),
								triangles,
								results.defects.data(),
								results.gradient.data()}
		.run<Number>();
	return results;
}

} // namespace developable::test
