// SPDX-License-Identifier: GPL-3.0-or-later
// principal_curvatures.cpp: a quadric over the tangent plane of each vertex copy, and its curvatures.
#include "principal_curvatures.h"

#include "second_rings.h"
#include "vertex_normals.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable {
namespace {

/// Of a quadric over a plane that goes through a point: a x² + b xy + c y² + d x + e y.
constexpr int unknowns = 5;
using Quadric = Eigen::Matrix<double, unknowns, 1>;

/// The quadric that fits the points best in the sense of least squares; of several such the smallest.
/// \param points  3 x points, with x and y in the plane; at most 1 from the origin, so that no power of them
///                is small beside rounding
Quadric fitted(const Positions& points) {
	Eigen::Matrix<double, unknowns, unknowns> normal = Eigen::Matrix<double, unknowns, unknowns>::Zero();
	Quadric right = Quadric::Zero();
	for (const auto& p : points.colwise()) {
		Quadric row;
		row << p[0] * p[0], p[0] * p[1], p[1] * p[1], p[0], p[1];
		normal += row * row.transpose();
		right += p[2] * row;
	}
	return normal.completeOrthogonalDecomposition().solve(right);
}

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
	const detail::SecondRings rings(assembly);
	const Eigen::Matrix3Xd normals = copyNormals(assembly, positions);
	std::vector<int> ring;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		rings.collect(copy, ring);
		const Eigen::Vector3d normal = normals.col(copy);
		if (static_cast<int>(ring.size()) < unknowns || normal.isZero())
			continue;
		Eigen::Matrix3d frame;
		frame.row(0) = normal.unitOrthogonal();
		frame.row(1) = normal.cross(Eigen::Vector3d(frame.row(0)));
		frame.row(2) = normal;
		Positions points(3, ring.size());
		for (Eigen::Index i = 0; i < points.cols(); ++i)
			points.col(i) = positions.col(assembly.placeOfCopy[ring[i]]);
		points.colwise() -= positions.col(assembly.placeOfCopy[copy]);
		const double reach = points.cwiseAbs().maxCoeff();
		const Eigen::Vector2d curvatures = curvaturesOf(fitted(frame * (points / reach))) / reach;
		if (!curvatures.allFinite())
			continue;
		result.least[copy] = curvatures[0];
		result.greatest[copy] = curvatures[1];
	}
	return result;
}

} // namespace developable
