// SPDX-License-Identifier: GPL-3.0-or-later
// smallest_box.cpp: turns about one axis after the other, by smaller and smaller angles.
#include "smallest_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace developable::detail {

namespace {

constexpr int directions = 600;                           ///< whose farthest points stand for all
constexpr double firstStep = pi / 8, lastStep = pi / 1e4; ///< rad

/// The farthest points along directions that are spread evenly (a Fibonacci lattice): a few hundred say
/// nearly as much of boxes as all.
Positions farthestPoints(const Positions& points) {
	if (points.cols() <= directions)
		return points;
	std::vector<Eigen::Index> farthest;
	const double turn = pi * (3 - std::sqrt(5.0));
	for (int i = 0; i < directions; ++i) {
		const double z = 1 - (2 * i + 1.0) / directions, radius = std::sqrt(1 - z * z);
		const Eigen::Vector3d direction(radius * std::cos(turn * i), radius * std::sin(turn * i), z);
		Eigen::Index most = 0;
		(direction.transpose() * points).maxCoeff(&most);
		farthest.push_back(most);
	}
	std::sort(farthest.begin(), farthest.end());
	farthest.erase(std::unique(farthest.begin(), farthest.end()), farthest.end());
	return points(Eigen::all, farthest);
}

/// The turn to the least box that can be reached from one by steps.
Eigen::Matrix3d leastFrom(const Positions& points, const Eigen::Matrix3d& start) {
	Eigen::Matrix3d best = start;
	double least = boxDiagonal(best * points);
	for (double step = firstStep; step > lastStep;) {
		bool any = false;
		for (int axis = 0; axis < 3; ++axis)
			for (const double angle : {step, -step}) {
				const Eigen::Matrix3d turned =
					Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix() * best;
				const double diagonal = boxDiagonal(turned * points);
				if (diagonal >= least * (1 - 1e-12))
					continue;
				least = diagonal;
				best = turned;
				any = true;
			}
		if (!any)
			step /= 2;
	}
	return best;
}

} // namespace

double smallestBoxDiagonal(const Positions& points) {
	const Positions farthest = farthestPoints(points);
	double least = boxDiagonal(points);
	for (const double x : {0.0, pi / 4})
		for (const double y : {0.0, pi / 4})
			for (const double z : {0.0, pi / 4}) {
				const Eigen::Matrix3d start = (Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()) *
											   Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY()) *
											   Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ()))
												  .toRotationMatrix();
				least = std::min(least, boxDiagonal(leastFrom(farthest, start) * points));
			}
	return least;
}

} // namespace developable::detail
