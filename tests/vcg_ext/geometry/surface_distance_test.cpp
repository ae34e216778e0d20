// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/geometry/geometry.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

Eigen::Matrix3Xi oneTriangle() {
	return Eigen::Vector3i(0, 1, 2);
}

double distanceTo(const Positions& triangle, const Eigen::Vector3d& point) {
	return distancesToSurface(point, triangle, oneTriangle())[0];
}

/// The least distance to a fine net of points on the surface: slow, obvious and a little too large.
double distanceBySampling(const Eigen::Vector3d& point, const TriangleMesh& surface, int steps) {
	double least = std::numeric_limits<double>::max();
	for (const auto& t : surface.triangles.colwise())
		for (int i = 0; i <= steps; ++i)
			for (int j = 0; i + j <= steps; ++j) {
				const double a = double(i) / steps, b = double(j) / steps;
				const Eigen::Vector3d sample = a * surface.positions.col(t[0]) +
											   b * surface.positions.col(t[1]) +
											   (1 - a - b) * surface.positions.col(t[2]);
				least = std::min(least, (sample - point).norm());
			}
	return least;
}

/// Points round the unit cube, from near the surface to far away.
Positions scatteredPoints(int count, double spread) {
	std::mt19937 random(11);
	Positions points(3, count);
	for (double& coordinate : points.reshaped())
		coordinate = 0.5 + spread * (2.0 * random() / std::mt19937::max() - 1);
	return points;
}

TEST(SurfaceDistance, IsMeasuredToFaceEdgeOrCornerWhicheverIsNearest) {
	Positions triangle(3, 3);
	triangle << 0, 4, 0, 0, 0, 3, 0, 0, 0;
	EXPECT_NEAR(distanceTo(triangle, {1, 1, 2}), 2, 1e-15);        // above the face
	EXPECT_NEAR(distanceTo(triangle, {1, 1, -2}), 2, 1e-15);       // below it
	EXPECT_NEAR(distanceTo(triangle, {2, -1, 0}), 1, 1e-15);       // beside an edge, in the plane
	EXPECT_NEAR(distanceTo(triangle, {2, -3, 4}), 5, 1e-15);       // beside an edge, above the plane
	EXPECT_NEAR(distanceTo(triangle, {-3, -4, 0}), 5, 1e-15);      // at a corner
	EXPECT_NEAR(distanceTo(triangle, {4, 3, 0}), 12.0 / 5, 1e-15); // beside the slanted edge
}

TEST(SurfaceDistance, FindsTheNearerOfTwoEdgesAtAnObtuseCorner) {
	Positions triangle(3, 3);
	triangle << -10, 0, 10, 1, 0, 1, 0, 0, 0; // the corner at the origin has nearly 180 degrees
	// Outside both edges that meet in the corner, nearest to the left one and to the right one.
	const double slope = std::atan2(1, 10);
	for (const double side : {-1.0, 1.0}) {
		const Eigen::Vector3d onEdge(side * 5, 0.5, 0), outwards(side * std::sin(slope), -std::cos(slope), 0);
		EXPECT_NEAR(distanceTo(triangle, onEdge + 0.25 * outwards), 0.25, 1e-15);
	}
}

TEST(SurfaceDistance, IsZeroOnTheSurface) {
	const TriangleMesh surface = jitteredGrid(17, 13, saddle);
	Positions onFaces(3, surface.triangleCount());
	for (int t = 0; t < surface.triangleCount(); ++t)
		onFaces.col(t) = (surface.positions.col(surface.triangles(0, t)) +
						  2 * surface.positions.col(surface.triangles(1, t)) +
						  surface.positions.col(surface.triangles(2, t))) /
						 4;
	EXPECT_EQ(distancesToSurface(surface.positions, surface.positions, surface.triangles).maxCoeff(), 0);
	EXPECT_LT(distancesToSurface(onFaces, surface.positions, surface.triangles).maxCoeff(), 1e-15);
}

TEST(SurfaceDistance, AgreesWithSamplingNearAndFar) {
	const TriangleMesh surface = jitteredGrid(9, 7, bumpedCylinder);
	for (const double spread : {0.5, 3.0, 1000.0}) {
		const Positions points = scatteredPoints(40, spread);
		const Eigen::VectorXd distances = distancesToSurface(points, surface.positions, surface.triangles);
		for (Eigen::Index i = 0; i < points.cols(); ++i) {
			const double sampled = distanceBySampling(points.col(i), surface, 24);
			EXPECT_LE(distances[i], sampled * (1 + 1e-14));
			EXPECT_GE(distances[i], sampled - 0.2 / 24); // triangles have edges of at most 0.2
		}
	}
}

TEST(SurfaceDistance, KnowsWhichTriangleIsNearest) {
	const TriangleMesh surface = sphere(1, 2);
	const Positions points = scatteredPoints(200, 2);
	const std::vector<int> nearest = nearestTriangles(points, surface.positions, surface.triangles);
	const Eigen::VectorXd distances = distancesToSurface(points, surface.positions, surface.triangles);
	ASSERT_EQ(nearest.size(), 200u);
	for (int i = 0; i < 200; ++i) {
		const Positions corners = surface.positions(Eigen::all, surface.triangles.col(nearest[i]));
		EXPECT_NEAR(distanceTo(corners, points.col(i)), distances[i], 1e-12) << i;
	}
}

TEST(SurfaceDistance, DoesNotDependOnTheOrderOfThePoints) {
	const TriangleMesh surface = jitteredGrid(21, 21, saddle);
	const Positions points = scatteredPoints(200, 1);
	const Eigen::VectorXd forwards = distancesToSurface(points, surface.positions, surface.triangles);
	const Eigen::VectorXd backwards =
		distancesToSurface(points.rowwise().reverse(), surface.positions, surface.triangles).reverse();
	EXPECT_LT((forwards - backwards).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(SurfaceDistance, ScalesWithLengthsWhoseSixthPowerIsNoNumber) {
	const TriangleMesh surface = jitteredGrid(9, 7, bumpedCylinder);
	const Positions points = scatteredPoints(40, 1);
	const Eigen::VectorXd distances = distancesToSurface(points, surface.positions, surface.triangles);
	for (const double scale : {1e60, 1e-60}) {
		const Eigen::VectorXd scaled =
			distancesToSurface(scale * points, scale * surface.positions, surface.triangles) / scale;
		EXPECT_LT((scaled - distances).cwiseAbs().maxCoeff(), 1e-14) << scale;
	}
}

} // namespace
} // namespace developable::test
