// SPDX-License-Identifier: GPL-3.0-or-later
// candidate_axes.cpp: principal axes, and where these are not distinct axes through unusual vertices.
#include "candidate_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace developable::detail {

namespace {

constexpr double distinct = 1e-3; ///< of the trace: principal moments that are nearer leave axes open
constexpr double offAxis = 0.3;   ///< of the radius of gyration: what is nearer to an axis tells no direction
constexpr double alike = 1e-8;    ///< of the radius of gyration: far more than turning changes
constexpr double mostVertices = 4e6; ///< of all forms that are compared

/// Vertices by a measure that no turn changes, the fewest alike first.
class VertexClasses {
public:
	explicit VertexClasses(const TriangleMesh& mesh) : mesh_(mesh) {
		Eigen::VectorXd ring = Eigen::VectorXd::Zero(mesh.vertexCount());
		for (const auto& t : mesh.triangles.colwise()) {
			const double area = (mesh.positions.col(t[1]) - mesh.positions.col(t[0]))
									.cross(mesh.positions.col(t[2]) - mesh.positions.col(t[0]))
									.norm();
			for (const int vertex : t)
				ring[vertex] += area;
		}
		const Eigen::VectorXd measure = mesh.positions.colwise().norm().transpose() + 0.6 * ring.cwiseSqrt();
		std::vector<int> order(mesh.vertexCount());
		std::iota(order.begin(), order.end(), 0);
		std::sort(order.begin(), order.end(), [&](int a, int b) { return measure[a] < measure[b]; });
		for (std::size_t i = 0; i < order.size(); ++i) {
			if (i == 0 || measure[order[i]] - measure[order[i - 1]] > alike)
				classes_.emplace_back();
			classes_.back().push_back(order[i]);
		}
		std::stable_sort(classes_.begin(), classes_.end(),
						 [](const auto& a, const auto& b) { return a.size() < b.size(); });
	}

	/// Of the first class that has any vertex off an axis, all directions away from the axis.
	/// \param axis  unit length, or 0: off the centre
	std::vector<Eigen::Vector3d> directionsOff(const Eigen::Vector3d& axis) const {
		std::vector<Eigen::Vector3d> found;
		for (auto members = classes_.begin(); found.empty() && members != classes_.end(); ++members)
			for (const int vertex : *members) {
				const Eigen::Vector3d point = mesh_.positions.col(vertex),
									  off = point - axis.dot(point) * axis;
				if (off.norm() > offAxis)
					found.push_back(off.normalized());
			}
		return found;
	}

private:
	const TriangleMesh& mesh_;
	std::vector<std::vector<int>> classes_;
};

/// The rotation that brings z to the third axis and x, which is at a right angle to it, to the first.
Eigen::Matrix3d rotationTo(const Eigen::Vector3d& x, const Eigen::Vector3d& z) {
	Eigen::Matrix3d rotation;
	rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
	return rotation;
}

} // namespace

AreaMoments areaMoments(const TriangleMesh& mesh) {
	const Eigen::Vector3d origin = mesh.positions.rowwise().mean(); // keeps digits far from the mesh's own
	AreaMoments moments;
	double sum = 0;
	for (const auto& t : mesh.triangles.colwise()) {
		const Eigen::Matrix3d points = mesh.positions(Eigen::all, t).colwise() - origin;
		const Eigen::Vector3d whole = points.rowwise().sum();
		const double area = (points.col(1) - points.col(0)).cross(points.col(2) - points.col(0)).norm();
		sum += area;
		moments.centre += area * whole / 3;
		moments.covariance += area * (points * points.transpose() + whole * whole.transpose()) / 12;
	}
	moments.centre /= sum;
	moments.covariance = moments.covariance / sum - (moments.centre * moments.centre.transpose()).eval();
	moments.centre += origin;
	return moments;
}

std::vector<Eigen::Matrix3d> candidateAxes(const TriangleMesh& mesh, const Eigen::Matrix3d& covariance) {
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
	const Eigen::Vector3d& moments = solver.eigenvalues();
	const bool lower = moments[1] - moments[0] > distinct, upper = moments[2] - moments[1] > distinct;
	std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axes; // x, z
	const auto add = [&](const std::vector<Eigen::Vector3d>& directions, const Eigen::Vector3d& z) {
		for (const Eigen::Vector3d& x : directions)
			axes.emplace_back(x, z);
	};
	if (lower && upper) {
		const Eigen::Vector3d x = solver.eigenvectors().col(0), z = solver.eigenvectors().col(2);
		add({x, -x}, z);
		add({x, -x}, -z);
	} else {
		const VertexClasses classes(mesh);
		std::vector<Eigen::Vector3d> first;
		if (lower || upper) {
			const Eigen::Vector3d axis = solver.eigenvectors().col(lower ? 0 : 2);
			first = {axis, -axis};
		} else {
			first = classes.directionsOff(Eigen::Vector3d::Zero());
		}
		for (const Eigen::Vector3d& z : first)
			if (double(axes.size()) * mesh.vertexCount() <= mostVertices)
				add(classes.directionsOff(z), z);
	}
	if (axes.empty() || double(axes.size()) * mesh.vertexCount() > mostVertices)
		return {Eigen::Matrix3d::Identity()};
	std::vector<Eigen::Matrix3d> rotations;
	rotations.reserve(axes.size());
	for (const auto& [x, z] : axes)
		rotations.push_back(rotationTo(x, z));
	return rotations;
}

} // namespace developable::detail
