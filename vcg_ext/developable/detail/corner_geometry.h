// SPDX-License-Identifier: GPL-3.0-or-later
// corner_geometry.h: the three corner angles of a triangle and how they change when its vertices move.
#pragma once

#include "../constants.h"
#include "triangle_kernel.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace developable::detail {

/// A triangle's edge vectors, edge k opposite to corner k, and its normal with twice the area as length.
struct TriangleFrame {
	Eigen::Vector3d edge[3];
	Eigen::Vector3d normal;

	TriangleFrame(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2)
		: edge{p2 - p1, p0 - p2, p1 - p0}, normal(edge[2].cross(-edge[1])) {}

	/// The cotangent of corner k is this divided by twice the area.
	double cotangentTimesDoubleArea(int corner) const {
		return -edge[(corner + 1) % 3].dot(edge[(corner + 2) % 3]);
	}

	double angle(int corner) const { return std::atan2(normal.norm(), cotangentTimesDoubleArea(corner)); }
};

/// The cotangents of a triangle's three corners.
inline Eigen::Vector3d cotangents(const TriangleFrame& frame) {
	const Eigen::Vector3d &u = frame.edge[2], v = -frame.edge[1];
	const TriangleShape shape = triangleShape({u[0], u[1], u[2]}, {v[0], v[1], v[2]});
	return {shape.cotangent[0], shape.cotangent[1], shape.cotangent[2]};
}

/// The vectors r_k = n × e_k / |e_k|², with n the unit normal. A corner's angle θ_i grows by r_j + r_k when
/// p_i moves, by −r_k when p_j moves and by −r_j when p_k moves: nine gradients from three vectors.
struct AngleGradients {
	Eigen::Vector3d r[3];

	explicit AngleGradients(const TriangleFrame& frame) {
		const double inverseNorm = 1 / frame.normal.norm();
		for (int k = 0; k < 3; ++k)
			r[k] = frame.normal.cross(frame.edge[k]) * (inverseNorm / frame.edge[k].squaredNorm());
	}

	/// The gradient of the angle at a corner with respect to a vertex of the triangle.
	Eigen::Vector3d of(int corner, int vertex) const {
		if (corner == vertex)
			return r[(corner + 1) % 3] + r[(corner + 2) % 3];
		return -r[3 - corner - vertex];
	}

	/// The gradient of Σ weight_i θ_i with respect to a vertex of the triangle.
	Eigen::Vector3d weighted(const Eigen::Vector3d& weights, int vertex) const {
		const int next = (vertex + 1) % 3, last = (vertex + 2) % 3;
		return (weights[vertex] - weights[next]) * r[last] + (weights[vertex] - weights[last]) * r[next];
	}
};

/// Adds up the angles of a fan as the argument of a product of complex numbers, so that one arctangent serves
/// the whole fan. Each angle lies between 0 and π, so the running sum passes at most one multiple of π at a
/// time, which shows in the sign of the imaginary part: half turns are counted and nothing is lost beyond 2π.
class AngleSum {
public:
	/// Adds the angle with this cotangent.
	void add(double cotangent) {
		const double real = real_ * cotangent - imaginary_;
		const double imaginary = real_ + imaginary_ * cotangent;
		halfTurns_ += (imaginary < 0) != (imaginary_ < 0);
		real_ = real;
		imaginary_ = imaginary;
		// Thin triangles have large cotangents; the argument does not care for the modulus.
		if (std::abs(real) + std::abs(imaginary) > 1e100) {
			real_ *= 1e-100;
			imaginary_ *= 1e-100;
		}
	}

	/// 2π minus the sum, exact to rounding of the difference itself near 0.
	double defect() const {
		const int turns = (halfTurns_ + 1) / 2;
		return 2 * pi * (1 - turns) - std::atan2(imaginary_, real_);
	}

private:
	double real_ = 1, imaginary_ = 0;
	int halfTurns_ = 0;
};

} // namespace developable::detail
