// SPDX-License-Identifier: GPL-3.0-or-later
// shape_runs.cpp: what measures a shape, lays it flat, or triangulates a polygon.
#include "runs.h"

#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/polygons/polygon_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace developable::fuzz {

namespace {

/// The least distance to points spread over the triangles, and how much less the distance to the triangles
/// may be.
struct SampledDistance {
	double least, lessAtMost;
};

SampledDistance sampledDistance(const Eigen::Vector3d& point, const Positions& vertices,
								const Eigen::Matrix3Xi& triangles) {
	constexpr int steps = 8;
	const double infinity = std::numeric_limits<double>::infinity();
	double least = infinity, leastPossible = infinity;
	for (const auto& t : triangles.colwise()) {
		const Eigen::Vector3d a = vertices.col(t[0]), b = vertices.col(t[1]) - a, c = vertices.col(t[2]) - a;
		const double spacing = std::max({b.norm(), c.norm(), (b - c).norm()}) / steps;
		for (int i = 0; i <= steps; ++i)
			for (int j = 0; i + j <= steps; ++j) {
				const double distance = (a + (i * b + j * c) / steps - point).norm();
				least = std::min(least, distance);
				leastPossible = std::min(leastPossible, distance - spacing);
			}
	}
	return {least, least - leastPossible};
}

void checkPatterns(const PatchAssembly& assembly, const FlatPatterns& patterns, Findings& findings) {
	findings.expect(patterns.positions.allFinite(), "patterns that are not finite");
	findings.expect(patterns.report.pieces == assembly.patchCount() &&
						patterns.triangles.cols() == assembly.triangleCount(),
					"a wrong number of pieces or triangles");
	double maxStrain = 0, slack = 1e-9;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int next = h % 3 == 2 ? h - 2 : h + 1;
		const int start = patterns.triangles.data()[h], end = patterns.triangles.data()[next];
		findings.expect(patterns.placeOfVertex[start] == assembly.placeAt(h), "a corner in another place");
		const double length = (assembly.originalPositions.col(assembly.placeAt(next)) -
							   assembly.originalPositions.col(assembly.placeAt(h)))
								  .norm();
		const double flat = (patterns.positions.col(end) - patterns.positions.col(start)).norm();
		maxStrain = std::max(maxStrain, std::abs(flat - length) / length);
		slack = std::max(slack, 1e-14 * patterns.positions.cwiseAbs().maxCoeff() / length);
	}
	findings.expect(std::abs(patterns.report.maxEdgeStrain - maxStrain) <= slack * (1 + maxStrain),
					"an edge strain of " + std::to_string(maxStrain) + ", reported as " +
						std::to_string(patterns.report.maxEdgeStrain));
	for (const Seam& seam : patterns.seams)
		findings.expect(seam.halfEdges[0].size() == seam.halfEdges[1].size() &&
							std::isfinite(seam.mismatch()),
						"a seam of unequal sides");
}

/// A contour round a centre, in a plane of any direction, mostly simple, or any corners at all.
Positions hostileContour(Random& random) {
	const int corners = random.below(12);
	const double noise = random.oneOf({0.0, 0.0, 1e-9, 0.1, 3.0});
	const double grid = random.oneOf({0.0, 0.0, 2.0, 8.0});
	const Eigen::Vector3d x(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
	const Eigen::Vector3d y(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
	Positions contour(3, corners);
	for (int corner = 0; corner < corners; ++corner) {
		const double angle = 2 * pi * corner / corners, radius = random.between(0.1, 1);
		contour.col(corner) = radius * (std::cos(angle) * x + std::sin(angle) * y);
		for (double& coordinate : contour.col(corner))
			coordinate += noise * random.between(-1, 1);
	}
	if (grid > 0)
		contour = (contour * grid).array().round() / grid;
	return contour * random.oneOf({1.0, 1.0, random.magnitude(-20, 20)});
}

} // namespace

void runMeasure(Random& random, const PatchAssembly& assembly, Findings& findings) {
	const Positions& positions = assembly.originalPositions;
	const double tolerance = random.oneOf({1e-4, 0.0, 0.1});
	const Measures measures = measure(assembly, positions, tolerance);
	const OwnDefects own = ownDefects(assembly, positions);
	const double error = own.errors.sum() + 1e-12 * own.values.cwiseAbs().sum();
	findings.expect(measures.developability >= 0 && measures.developability <= 1,
					"a developability beyond 0 to 1");
	findings.expect(std::abs(measures.detectFunction - own.detectFunction()) <=
						own.detectError() + 1e-12 * own.detectFunction(),
					"a wrong detect function");
	findings.expect(std::abs(measures.totalAbsoluteCurvature - own.values.cwiseAbs().sum()) <= error,
					"a wrong total absolute curvature");
	findings.expect(std::abs(measures.maxAngleDefect - own.values.cwiseAbs().maxCoeff()) <= error,
					"a wrong largest angle defect");
	findings.expect(gaussianCurvatureMap(assembly, positions).allFinite(),
					"a Gaussian curvature that is not finite");
	const PrincipalCurvatures principal = principalCurvatures(assembly, positions);
	findings.expect(principal.least.allFinite() && principal.greatest.allFinite(),
					"a principal curvature that is not finite");
}

void runFlattenPatches(Random& random, const PatchAssembly& assembly, Findings& findings) {
	FlattenOptions options;
	options.iterations = random.oneOf({0, 1, 10, 40});
	options.gap = random.oneOf({-1.0, -1.0, 0.0, 1.0});
	if (random.chance(0.02))
		options.gap = random.oneOf({std::nan(""), std::numeric_limits<double>::infinity()});
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions, options);
	checkPatterns(assembly, patterns, findings);
}

void runTriangulatePolygon(Random& random, const PatchAssembly&, Findings& findings) {
	const Positions contour = hostileContour(random);
	const int corners = static_cast<int>(contour.cols());
	const auto triangles = triangulatePolygon(contour);
	if (!triangles)
		return;
	findings.expect(corners >= 3 && triangles->cols() == corners - 2,
					"a wrong number of triangles in a polygon");
	std::set<std::pair<int, int>> halfEdges;
	for (const auto& t : triangles->colwise())
		for (int side = 0; side < 3; ++side) {
			const int start = t[side], end = t[(side + 1) % 3];
			findings.expect(start >= 0 && start < corners, "a corner out of range");
			findings.expect(halfEdges.emplace(start, end).second, "two triangles on one side of an edge");
		}
	for (const auto& [start, end] : halfEdges)
		findings.expect(end == (start + 1) % corners || halfEdges.count({end, start}) == 1,
						"an open diagonal in a polygon");
	for (int corner = 0; corner < corners; ++corner)
		findings.expect(halfEdges.count({corner, (corner + 1) % corners}) == 1,
						"a side of a polygon without triangle");
}

void runDistancesToSurface(Random& random, const PatchAssembly& assembly, Findings& findings) {
	const Positions& vertices = assembly.originalPositions;
	const double size = boxDiagonal(vertices);
	Positions points(3, random.below(8));
	for (auto point : points.colwise()) {
		point = vertices.col(random.below(assembly.placeCount()));
		const double away = random.oneOf({0.0, 1e-9, 0.1, 10.0}) * size;
		for (double& coordinate : point)
			coordinate += away * random.between(-1, 1);
	}
	const Eigen::VectorXd distances = distancesToSurface(points, vertices, assembly.trianglePlaces);
	findings.expect(distances.size() == points.cols(), "a wrong number of distances");
	for (int i = 0; i < points.cols(); ++i) {
		const auto [least, lessAtMost] = sampledDistance(points.col(i), vertices, assembly.trianglePlaces);
		const double slack = 1e-7 * (size + least) + 1e-12 * vertices.cwiseAbs().maxCoeff();
		findings.expect(distances[i] >= 0 && distances[i] <= least + slack, "too large a distance");
		findings.expect(distances[i] >= least - lessAtMost - slack, "too small a distance");
	}
}

} // namespace developable::fuzz
