// SPDX-License-Identifier: GPL-3.0-or-later
// flat_start.h: first layouts of a panel in the plane: a conformal one, exact for developable panels, and one
// that never flips a triangle.
#pragma once

#include "panel_mesh.h"
#include "sparse_cholesky.h"

#include <cmath>

namespace developable::detail {

inline int countFlipped(const Eigen::Matrix3Xi& triangles, const PlanePositions& positions) {
	int count = 0;
	for (const auto& triangle : triangles.colwise())
		count += !(doubleArea(positions, triangle) > 0);
	return count;
}

/// A weighted graph Laplacian on a panel, solved inside for given values on the boundary.
class DirichletProblem {
public:
	/// \param weights  per half edge; an edge's weight is the sum over its half edges
	/// \param inner    per vertex, whether its value is sought
	DirichletProblem(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& weights,
					 const std::vector<char>& inner)
		: number_(inner.size(), -1) {
		for (std::size_t vertex = 0; vertex < inner.size(); ++vertex)
			if (inner[vertex])
				number_[vertex] = count_++;
		std::vector<Eigen::Triplet<double>> inside, across;
		inside.reserve(2 * weights.size());
		for (int h = 0; h < weights.size(); ++h)
			for (const auto& [a, b] : {std::pair(triangles.data()[h], triangles.data()[nextCorner(h)]),
									   std::pair(triangles.data()[nextCorner(h)], triangles.data()[h])}) {
				if (number_[a] < 0)
					continue;
				inside.emplace_back(number_[a], number_[a], weights[h]);
				if (number_[b] < 0)
					across.emplace_back(number_[a], b, weights[h]);
				else if (number_[b] < number_[a])
					inside.emplace_back(number_[a], number_[b], -weights[h]);
			}
		SparseMatrix matrix(count_, count_);
		matrix.setFromTriplets(inside.begin(), inside.end());
		boundary_.resize(count_, static_cast<int>(inner.size()));
		boundary_.setFromTriplets(across.begin(), across.end());
		solvable_ = count_ == 0 || solver_.factorize(matrix);
	}

	bool solvable() const { return solvable_; }

	/// \param values   vertices x n; those on the boundary are read, those inside are written
	/// \param sources  vertices x n, what the Laplacian of the values is to be
	void solve(Eigen::MatrixXd& values, const Eigen::MatrixXd& sources) const {
		if (count_ == 0)
			return;
		Eigen::MatrixXd rightHandSide = boundary_ * values;
		for (std::size_t vertex = 0; vertex < number_.size(); ++vertex)
			if (number_[vertex] >= 0)
				rightHandSide.row(number_[vertex]) += sources.row(vertex);
		const Eigen::MatrixXd solution = solver_.solve(rightHandSide);
		for (std::size_t vertex = 0; vertex < number_.size(); ++vertex)
			if (number_[vertex] >= 0)
				values.row(vertex) = solution.row(number_[vertex]);
	}

private:
	std::vector<int> number_; // among the vertices inside, or -1
	int count_ = 0;
	Eigen::SparseMatrix<double> boundary_;
	SparseCholesky solver_;
	bool solvable_ = true;
};

/// Half the cotangent of the angle opposite to each half edge.
inline Eigen::VectorXd cotangentWeights(const PanelMesh& panel) {
	Eigen::VectorXd weights(panel.halfEdgeCount());
	for (int t = 0; t < panel.triangleCount(); ++t) {
		const auto triangle = panel.triangles.col(t);
		const TriangleFrame frame(panel.positions.col(triangle[0]), panel.positions.col(triangle[1]),
								  panel.positions.col(triangle[2]));
		for (int corner = 0; corner < 3; ++corner)
			weights[3 * t + nextCorner(corner)] =
				frame.cotangentTimesDoubleArea(corner) / (2 * frame.normal.norm());
	}
	return weights;
}

inline std::vector<char> insideLoops(int vertexCount, const PanelMesh& panel,
									 const std::vector<std::vector<int>>& loops) {
	std::vector<char> inside(vertexCount, 1);
	for (const std::vector<int>& loop : loops)
		for (const int h : loop)
			inside[panel.start(h)] = 0;
	return inside;
}

/// Draws a closed boundary in the plane that turns by the given angles and keeps the half edges' lengths as
/// nearly as it can close.
///
/// \return 2 x the loop's vertices
inline PlanePositions drawBoundary(const PanelMesh& panel, const std::vector<int>& loop,
								   const Eigen::VectorXd& turning) {
	const int count = static_cast<int>(loop.size());
	PlanePositions tangents(2, count);
	Eigen::VectorXd lengths(count);
	double direction = 0;
	for (int i = 0; i < count; ++i) {
		direction += turning[panel.start(loop[i])];
		tangents.col(i) << std::cos(direction), std::sin(direction);
		lengths[i] = panel.length(loop[i]);
	}
	// The least change of the lengths, weighted by their inverses, that closes the polygon.
	const Eigen::Matrix2d moments = tangents * lengths.asDiagonal() * tangents.transpose();
	const Eigen::Vector2d gap = tangents * lengths;
	lengths.array() *= 1 - (tangents.transpose() * moments.ldlt().solve(gap)).array();
	PlanePositions points(2, count);
	points.col(0).setZero();
	for (int i = 1; i < count; ++i)
		points.col(i) = points.col(i - 1) + lengths[i - 1] * tangents.col(i - 1);
	return points;
}

/// The conformal map of a disk that leaves boundary lengths as they are (Sawhney and Crane, "Boundary First
/// Flattening", 2017): of all conformal maps it has the least distortion of area, and a developable disk
/// comes out isometric. It may flip triangles of other disks.
///
/// \return 2 x vertices, or none when it can't be found
inline PlanePositions conformalStart(const PanelMesh& disk) {
	const std::vector<std::vector<int>> loops = boundaryLoops(disk);
	const std::vector<int>& loop = loops.front();
	const Eigen::VectorXd weights = cotangentWeights(disk);
	const std::vector<char> inside = insideLoops(disk.vertexCount(), disk, loops);
	const DirichletProblem laplacian(disk.triangles, weights, inside);
	if (!laplacian.solvable())
		return {};

	// The logarithm u of the scale that takes the curvature away, 0 on the boundary; what the boundary then
	// turns by is what it turns by on the model plus the flow of u across it.
	const Eigen::VectorXd angles = angleSums(disk);
	Eigen::MatrixXd scale = Eigen::VectorXd::Zero(disk.vertexCount());
	laplacian.solve(scale, (angles.array() - 2 * pi).matrix());
	Eigen::VectorXd turning = (pi - angles.array()).matrix();
	for (int h = 0; h < disk.halfEdgeCount(); ++h) {
		const double flow = weights[h] * (scale(disk.start(h)) - scale(disk.end(h)));
		turning[disk.start(h)] += flow;
		turning[disk.end(h)] -= flow;
	}
	const PlanePositions boundary = drawBoundary(disk, loop, turning);
	Eigen::MatrixXd plane = Eigen::MatrixXd::Zero(disk.vertexCount(), 2);
	for (std::size_t i = 0; i < loop.size(); ++i)
		plane.row(disk.start(loop[i])) = boundary.col(i).transpose();
	laplacian.solve(plane, Eigen::MatrixXd::Zero(disk.vertexCount(), 2));
	return plane.transpose();
}

/// Tutte's embedding: the longest boundary on a circle, every other vertex the mean of its neighbours.
/// Without flips for every disk; the other boundaries are closed by a vertex each, in here only.
///
/// \return 2 x vertices, at the scale of the panel's area, or none when it can't be found
inline PlanePositions circleStart(const PanelMesh& panel, std::vector<std::vector<int>> loops) {
	const auto loopLength = [&](const std::vector<int>& loop) {
		double sum = 0;
		for (const int h : loop)
			sum += panel.length(h);
		return sum;
	};
	std::sort(loops.begin(), loops.end(),
			  [&](const auto& a, const auto& b) { return loopLength(a) > loopLength(b); });
	std::vector<Eigen::Vector3i> triangles(panel.triangles.colwise().begin(),
										   panel.triangles.colwise().end());
	int vertexCount = panel.vertexCount();
	for (std::size_t loop = 1; loop < loops.size(); ++loop, ++vertexCount)
		for (const int h : loops[loop])
			triangles.emplace_back(panel.end(h), panel.start(h), vertexCount);
	Eigen::Matrix3Xi closed(3, triangles.size());
	for (std::size_t t = 0; t < triangles.size(); ++t)
		closed.col(t) = triangles[t];

	loops.resize(1);
	const DirichletProblem laplacian(closed, Eigen::VectorXd::Ones(closed.size()),
									 insideLoops(vertexCount, panel, loops));
	if (!laplacian.solvable())
		return {};
	Eigen::MatrixXd plane = Eigen::MatrixXd::Zero(vertexCount, 2);
	const double circumference = loopLength(loops[0]);
	double along = 0;
	for (const int h : loops[0]) {
		const double angle = 2 * pi * along / circumference;
		plane.row(panel.start(h)) << std::cos(angle), std::sin(angle);
		along += panel.length(h);
	}
	laplacian.solve(plane, Eigen::MatrixXd::Zero(vertexCount, 2));
	double area = 0;
	for (const auto& triangle : panel.triangles.colwise())
		area += TriangleFrame(panel.positions.col(triangle[0]), panel.positions.col(triangle[1]),
							  panel.positions.col(triangle[2]))
					.normal.norm();
	return std::sqrt(area / (2 * pi)) * plane.topRows(panel.vertexCount()).transpose();
}

} // namespace developable::detail
