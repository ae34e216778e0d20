// SPDX-License-Identifier: GPL-3.0-or-later
// principal_curvatures.cpp: a quadric over the tangent plane of each vertex copy, and its curvatures.
#include "principal_curvatures.h"

#include "tangent_quadric.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable {
namespace {

using Quadric = Eigen::Matrix<double, detail::TangentQuadric::unknowns, 1>;

/// The absolute principal curvatures at the origin, the smaller first: from the mean and the Gaussian
/// curvature of a graph (do Carmo, Differential Geometry of Curves and Surfaces, Section 3-3).
Eigen::Vector2d curvaturesOf(const Quadric& quadric) {
	const double d = quadric[3], e = quadric[4], square = 1 + d * d + e * e;
	const double xx = 2 * quadric[0], xy = quadric[1], yy = 2 * quadric[2];
	const double gaussian = (xx * yy - xy * xy) / (square * square);
	const double mean =
		((1 + d * d) * yy - 2 * d * e * xy + (1 + e * e) * xx) / (2 * square * std::sqrt(square));
	const double spread = std::sqrt(std::max(mean * mean - gaussian, 0.0));
	const double one = std::abs(mean + spread), other = std::abs(mean - spread);
	return {std::min(one, other), std::max(one, other)};
}

} // namespace

PrincipalCurvatures principalCurvatures(const PatchAssembly& assembly, const Positions& positions) {
	PrincipalCurvatures result{Eigen::VectorXd::Zero(assembly.copyCount()),
							   Eigen::VectorXd::Zero(assembly.copyCount())};
	const auto add = [&](int copy, const std::vector<int>& /*ring*/, const detail::TangentQuadric& quadric) {
		const Eigen::Vector2d curvatures = curvaturesOf(quadric.fitted(quadric.heights())) / quadric.reach();
		if (!curvatures.allFinite())
			return;
		result.least[copy] = curvatures[0];
		result.greatest[copy] = curvatures[1];
	};
	detail::visitTangentQuadrics(assembly, positions, add);
	return result;
}

} // namespace developable
