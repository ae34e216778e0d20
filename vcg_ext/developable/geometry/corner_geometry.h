// SPDX-License-Identifier: GPL-3.0-or-later
// corner_geometry.h: the three corner angles of a triangle and how they change when its vertices move.
#pragma once

#include "developable/mesh/mesh.h"
#include "triangle_kernel.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace developable {

/// A triangle's edge vectors, edge k opposite to corner k, and its normal with twice the area as length.
struct TriangleFrame {
	Eigen::Vector3d edge[3];
	Eigen::Vector3d normal;

	TriangleFrame(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2)
		: edge{p2 - p1, p0 - p2, p1 - p0}, normal(edge[2].cross(-edge[1])) {}

	/// The cotangent of corner k is this divided by twice the area.
	double cotangentTimesDoubleArea(int corner) const {
		return -edge[nextCorner(corner)].dot(edge[previousCorner(corner)]);
	}

	double angle(int corner) const { return std::atan2(normal.norm(), cotangentTimesDoubleArea(corner)); }
};

/// The frame of the triangle whose corners lie at these places.
/// \param positions  3 x places
/// \param places     three of them
template <class Places>
TriangleFrame triangleFrame(const Positions& positions, const Places& places) {
	return {positions.col(places[0]), positions.col(places[1]), positions.col(places[2])};
}

/// The barycentre of the triangle whose corners lie at these places.
/// \param positions  3 x places
/// \param places     three of them
template <class Places>
Eigen::Vector3d barycentre(const Positions& positions, const Places& places) {
	return positions(Eigen::all, places).rowwise().mean();
}

/// The cotangents of a triangle's three corners.
inline Eigen::Vector3d cotangents(const TriangleFrame& frame) {
	const Eigen::Vector3d &u = frame.edge[2], v = -frame.edge[1];
	const detail::Cotangents<double> result(
		detail::TriangleEdges<double>({u[0], u[1], u[2]}, {v[0], v[1], v[2]}));
	return {result.corner[0], result.corner[1], result.corner[2]};
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
			return r[nextCorner(corner)] + r[previousCorner(corner)];
		return -r[3 - corner - vertex];
	}

	/// The gradient of Σ weight_i θ_i with respect to a vertex of the triangle.
	Eigen::Vector3d weighted(const Eigen::Vector3d& weights, int vertex) const {
		const int next = nextCorner(vertex), last = previousCorner(vertex);
		return (weights[vertex] - weights[next]) * r[last] + (weights[vertex] - weights[last]) * r[next];
	}
};

} // namespace developable
