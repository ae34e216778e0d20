// SPDX-License-Identifier: GPL-3.0-or-later
// newton_checks.h: what every result of the constrained Newton method has to be.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/newton/constrained_newton.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {

/// Two mirror images with a seam between them, each so many times as high as the surface.
inline PatchAssembly mirroredPatches(int columns, const Surface& surface, double height = 1) {
	TriangleMesh left = jitteredGrid(columns, columns, surface);
	left.positions.row(2) *= height;
	TriangleMesh right = left;
	right.positions.row(0) = 2 * left.positions.row(0).maxCoeff() - right.positions.row(0).array();
	return assembled(together(left, right));
}

/// Two halves of a bump with a seam along the middle.
inline PatchAssembly sewnPatches(int columns) {
	return mirroredPatches(columns, saddle);
}

/// A stop while the method says so: it has come that far, ends, and leaves the positions as they were.
inline void expectStopsAt(const std::string& saying, const PatchAssembly& assembly,
						  const ConstrainedNewtonOptions& options) {
	Positions positions = assembly.originalPositions;
	bool begun = false;
	const ConstrainedNewtonReport report =
		constrainedNewton(assembly, positions, options, [&](double, const std::string& message) {
			begun = begun || message.find(saying) != std::string::npos;
			return !begun;
		});
	EXPECT_TRUE(begun) << saying;
	EXPECT_EQ(report.status, Status::Stopped) << saying;
	EXPECT_EQ(positions, assembly.originalPositions) << saying;
}

inline double smallestAngle(const PatchAssembly& assembly, const Positions& positions) {
	double smallest = pi;
	for (const auto& places : assembly.trianglePlaces.colwise())
		for (int corner = 0; corner < 3; ++corner) {
			const Eigen::Vector3d at = positions.col(places[corner]);
			const Eigen::Vector3d a = positions.col(places[(corner + 1) % 3]) - at;
			const Eigen::Vector3d b = positions.col(places[(corner + 2) % 3]) - at;
			smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
		}
	return smallest;
}

inline Eigen::Vector3d unitNormal(const PatchAssembly& assembly, const Positions& positions, int triangle) {
	const auto places = assembly.trianglePlaces.col(triangle);
	const Eigen::Vector3d a = positions.col(places[1]) - positions.col(places[0]);
	const Eigen::Vector3d b = positions.col(places[2]) - positions.col(places[0]);
	return (assembly.triangleReversed[triangle] ? -1 : 1) * a.cross(b).normalized();
}

inline int flippedTriangles(const PatchAssembly& assembly, const Positions& positions) {
	int count = 0;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int across = assembly.joinedHalfEdge[h];
		if (across < 0)
			continue;
		const auto cosine = [&](const Positions& p) {
			return unitNormal(assembly, p, h / 3).dot(unitNormal(assembly, p, across / 3));
		};
		count += cosine(assembly.originalPositions) > 0 && !(cosine(positions) >= -0.5);
	}
	return count;
}

inline double meanDisplacement(const PatchAssembly& assembly, const Positions& positions) {
	const Positions& original = assembly.originalPositions;
	return (positions - original).colwise().norm().mean() / boxDiagonal(original);
}

/// What no result may suffer.
inline void expectSound(const PatchAssembly& assembly, const Positions& positions) {
	ASSERT_TRUE(positions.allFinite());
	EXPECT_EQ(flippedTriangles(assembly, positions), 0);
	EXPECT_GE(smallestAngle(assembly, positions),
			  std::min(smallestAngle(assembly, assembly.originalPositions) / 2, 2 * pi / 180));
}

/// Runs to the end and checks everything that "converged" promises.
inline Positions expectConverges(const PatchAssembly& assembly, double mostMeanDisplacement) {
	Positions positions = assembly.originalPositions;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
	EXPECT_EQ(report.status, Status::Converged);
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	EXPECT_LE(defects.cwiseAbs().maxCoeff(), 1e-4);
	for (int patch = 0; patch < assembly.patchCount(); ++patch) {
		double curvature = 0;
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			curvature += assembly.patchOfCopy[copy] == patch ? std::abs(defects[copy]) : 0;
		EXPECT_LE(curvature, 1e-4);
		EXPECT_NEAR(report.patchCurvature[patch], curvature, 1e-12);
	}
	EXPECT_LE(meanDisplacement(assembly, positions), mostMeanDisplacement);
	expectSound(assembly, positions);
	return positions;
}

/// Runs to the end and checks what "needs a cut" promises: less curvature than before, in order, and where
/// the report says that it sits.
inline void expectNeedsCut(const PatchAssembly& assembly) {
	Positions positions = assembly.originalPositions;
	const Measures before = measure(assembly, positions, 1e-4);
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
	const Measures after = measure(assembly, positions, 1e-4);
	EXPECT_EQ(report.status, Status::NeedsCut);
	EXPECT_LT(after.detectFunction, before.detectFunction);
	EXPECT_LT(after.totalAbsoluteCurvature, before.totalAbsoluteCurvature);
	EXPECT_NEAR(report.patchCurvature[report.worstPatch], after.totalAbsoluteCurvature, 1e-9);
	EXPECT_NEAR(std::abs(angleDefects(assembly, positions)[report.worstCopy]), after.maxAngleDefect, 1e-15);
	expectSound(assembly, positions);
}

} // namespace developable::test
