// SPDX-License-Identifier: GPL-3.0-or-later
// surface_distance_bench.cpp: processor seconds of a million distances to a surface, its tree built each
// time.
//
// surface_distance_bench TRIANGLES -> one line: triangles; seconds for points on the surface moved by 0,
// 0.001 and 0.1 of its size in the order of its vertices, then by 0.1 in random order
#include "developable/geometry/geometry.h"
#include "support/processor_time.h"
#include "support/shapes.h"

#include <cstdio>
#include <numeric>
#include <random>

namespace {

using namespace developable;

constexpr int queries = 1'000'000;

/// Points spread evenly over the vertices in their order, each moved by so much upward.
Positions queryPoints(const TriangleMesh& mesh, double away) {
	Positions points(3, queries);
	for (int i = 0; i < queries; ++i) {
		const auto vertex = static_cast<Eigen::Index>(double(i) / queries * mesh.vertexCount());
		points.col(i) = mesh.positions.col(vertex) + Eigen::Vector3d(0, 0, away);
	}
	return points;
}

void shuffle(Positions& points) {
	std::mt19937 random(1);
	for (Eigen::Index i = points.cols() - 1; i > 0; --i) {
		const auto j = static_cast<Eigen::Index>(random() % static_cast<unsigned>(i + 1));
		points.col(i).swap(points.col(j));
	}
}

double seconds(const TriangleMesh& mesh, const Positions& points) {
	return test::leastSeconds(
		[&] {
			if (!distancesToSurface(points, mesh.positions, mesh.triangles).allFinite())
				std::abort();
		},
		2);
}

} // namespace

int main(int count, char** arguments) {
	if (count != 2) {
		std::fprintf(stderr, "usage: surface_distance_bench TRIANGLES\n");
		return 2;
	}
	const int side = static_cast<int>(std::lround(std::sqrt(std::atof(arguments[1]) / 2))) + 1;
	const TriangleMesh mesh = test::jitteredGrid(side, side, test::bumpedCylinder);
	const double size = boxDiagonal(mesh.positions);
	std::printf("%d", mesh.triangleCount());
	for (const double away : {0.0, 1e-3, 0.1})
		std::printf(" %.3f", seconds(mesh, queryPoints(mesh, away * size)));
	Positions scattered = queryPoints(mesh, 0.1 * size);
	shuffle(scattered);
	std::printf(" %.3f\n", seconds(mesh, scattered));
	return 0;
}
