// SPDX-License-Identifier: GPL-3.0-or-later
// flat_start.cpp: Boundary First Flattening, and Tutte's embedding.
#include "flat_start.h"

#include "dirichlet_problem.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

/// Half the cotangent of the angle opposite to each half edge.
Eigen::VectorXd cotangentWeights(const PanelMesh& panel) {
	Eigen::VectorXd weights(panel.halfEdgeCount());
	for (int t = 0; t < panel.triangleCount(); ++t) {
		const TriangleFrame frame = panel.frame(t);
		for (int corner = 0; corner < 3; ++corner)
			weights[cornerOf(t, nextCorner(corner))] =
				frame.cotangentTimesDoubleArea(corner) / (2 * frame.normal.norm());
	}
	return weights;
}

/// Per vertex, whether it is on none of some loops.
std::vector<char> insideLoops(int vertexCount, const PanelMesh& panel,
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
PlanePositions drawBoundary(const PanelMesh& panel, const std::vector<int>& loop,
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

double lengthOf(const PanelMesh& panel, const std::vector<int>& loop) {
	double sum = 0;
	for (const int h : loop)
		sum += panel.length(h);
	return sum;
}

/// The panel's triangles, and a fan over every loop but the first, round a vertex of its own behind all
/// others.
Eigen::Matrix3Xi withClosedHoles(const PanelMesh& panel, const std::vector<std::vector<int>>& loops) {
	std::vector<Eigen::Vector3i> triangles(panel.triangles.colwise().begin(),
										   panel.triangles.colwise().end());
	int middle = panel.vertexCount();
	for (std::size_t loop = 1; loop < loops.size(); ++loop, ++middle)
		for (const int h : loops[loop])
			triangles.emplace_back(panel.end(h), panel.start(h), middle);
	Eigen::Matrix3Xi closed(3, triangles.size());
	for (std::size_t t = 0; t < triangles.size(); ++t)
		closed.col(t) = triangles[t];
	return closed;
}

} // namespace

PlanePositions conformalStart(const PanelMesh& disk) {
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

PlanePositions circleStart(const PanelMesh& panel, std::vector<std::vector<int>> loops) {
	std::sort(loops.begin(), loops.end(),
			  [&](const auto& a, const auto& b) { return lengthOf(panel, a) > lengthOf(panel, b); });
	const Eigen::Matrix3Xi closed = withClosedHoles(panel, loops);
	const int vertexCount = panel.vertexCount() + static_cast<int>(loops.size()) - 1;
	loops.resize(1);
	const DirichletProblem laplacian(closed, Eigen::VectorXd::Ones(closed.size()),
									 insideLoops(vertexCount, panel, loops));
	if (!laplacian.solvable())
		return {};
	Eigen::MatrixXd plane = Eigen::MatrixXd::Zero(vertexCount, 2);
	const double circumference = lengthOf(panel, loops[0]);
	double along = 0;
	for (const int h : loops[0]) {
		const double angle = 2 * pi * along / circumference;
		plane.row(panel.start(h)) << std::cos(angle), std::sin(angle);
		along += panel.length(h);
	}
	laplacian.solve(plane, Eigen::MatrixXd::Zero(vertexCount, 2));
	double area = 0;
	for (int t = 0; t < panel.triangleCount(); ++t)
		area += panel.frame(t).normal.norm();
	return std::sqrt(area / (2 * pi)) * plane.topRows(panel.vertexCount()).transpose();
}

} // namespace developable::detail
