// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten/area_hessian.h"

#include "developable/linear/linear.h"

#include <gtest/gtest.h>
#include <random>

namespace developable::test {
namespace {

using detail::AreaGradient;
using detail::AreaHessian;

/// By the corners, counter-clockwise.
double doubledArea(const AreaGradient& corners) {
	const Eigen::Vector2d u = corners.segment<2>(2) - corners.head<2>(),
						  v = corners.tail<2>() - corners.head<2>();
	return u[0] * v[1] - u[1] * v[0];
}

AreaGradient gradientOf(const AreaGradient& corners) {
	AreaGradient gradient;
	for (int i = 0; i < 6; ++i) { // exact: the area is quadratic
		AreaGradient more = corners, less = corners;
		more[i] += 1;
		less[i] -= 1;
		gradient[i] = (doubledArea(more) - doubledArea(less)) / 2;
	}
	return gradient;
}

std::vector<AreaGradient> triangles() {
	std::mt19937 random(3);
	std::normal_distribution<double> normal;
	std::vector<AreaGradient> all;
	for (int i = 0; i < 20; ++i)
		all.push_back(AreaGradient::NullaryExpr([&] { return normal(random); }));
	AreaGradient equilateral;
	equilateral << 0, 0, 1, 0, 0.5, std::sqrt(0.75);
	all.push_back(equilateral);
	all.push_back(AreaGradient::Zero());
	return all;
}

TEST(AreaHessian, isTheDerivativeOfTheGradient) {
	const double slope = -0.7, curvature = 1.3; // f(A) = slope A + curvature A² / 2 about A = 0
	for (const AreaGradient& corners : triangles()) {
		const double area = doubledArea(corners);
		const AreaHessian hessian =
			detail::areaHessian(gradientOf(corners), slope + curvature * area, curvature);
		const double h = 1e-4;
		for (int i = 0; i < 6; ++i) {
			AreaGradient more = corners, less = corners;
			more[i] += h;
			less[i] -= h;
			const AreaGradient derivative = ((slope + curvature * doubledArea(more)) * gradientOf(more) -
											 (slope + curvature * doubledArea(less)) * gradientOf(less)) /
											(2 * h);
			EXPECT_LT((derivative - hessian.col(i)).norm(), 1e-6 * (1 + hessian.norm()));
		}
	}
}

TEST(AreaHessian, convexIsTheNearestPositiveSemidefiniteMatrix) {
	for (const AreaGradient& corners : triangles())
		for (const double slope : {0.0, -1e-3, -1.0, -30.0})
			for (const double curvature : {0.0, 0.1, 1.0, 50.0}) {
				const AreaGradient area = gradientOf(corners);
				const AreaHessian hessian = detail::areaHessian(area, slope, curvature);
				const SymmetricEigen eigen = symmetricEigen(hessian);
				const AreaHessian nearest =
					eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
				EXPECT_LT((detail::convexAreaHessian(area, slope, curvature) - nearest).norm(),
						  1e-12 * (1 + hessian.norm()));
			}
}

} // namespace
} // namespace developable::test
