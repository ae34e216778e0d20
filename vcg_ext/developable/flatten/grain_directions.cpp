// SPDX-License-Identifier: GPL-3.0-or-later
// grain_directions.cpp: the grain along a side, or along a direction of the model as it comes to lie in the
// plane.
#include "grain_directions.h"

#include "developable/geometry/geometry.h"
#include "developable/linear/linear.h"

#include <cmath>
#include <utility>

namespace developable {

namespace {

double angleOf(const Eigen::Vector2d& direction) {
	return std::atan2(direction[1], direction[0]);
}

/// Where a direction of the model points in the plane, on the mean over the area: Σ w Fᵀa.
Eigen::Vector2d directionInPlane(const StrainedTriangles& triangles, const Positions& shaped,
								 const Eigen::Matrix2Xd& flat, const Eigen::Vector3d& direction) {
	Eigen::Vector2d sum = Eigen::Vector2d::Zero();
	for (int t = 0; t < triangles.count(); ++t) {
		const TriangleStrain strain(shaped(Eigen::all, triangles.shaped.col(t)),
									flat(Eigen::all, triangles.flat.col(t)));
		sum += triangles.weights[t] * strain.map.transpose() * direction;
	}
	return sum;
}

/// The grain of every triangle, rad.
std::vector<double> grainOfTriangles(const PatchAssembly& assembly, const Positions& model,
									 const FlatPatterns& patterns, const StrainedTriangles& triangles) {
	std::vector<double> ofPieces, result(triangles.count());
	for (int piece = 0; piece < assembly.patchCount(); ++piece)
		ofPieces.push_back(grainDirection(trianglesOfPiece(triangles, assembly, piece), model,
										  patterns.positions, patterns.grain,
										  patterns.pieces[piece].longestSide));
	for (int t = 0; t < triangles.count(); ++t)
		result[t] = ofPieces[assembly.patchOfTriangle[t]];
	return result;
}

} // namespace

Eigen::Vector2d principalDirection(const Eigen::Matrix2Xd& points) {
	const Eigen::Matrix2Xd centred = points.colwise() - points.rowwise().mean().eval();
	const Eigen::Vector2d direction = symmetricEigen(centred * centred.transpose()).vectors.col(1);
	return direction[1] < 0 ? -direction : direction;
}

double grainDirection(const StrainedTriangles& triangles, const Positions& shaped,
					  const Eigen::Matrix2Xd& flat, const Grain& grain,
					  const std::array<int, 2>& longestSide) {
	if (!grain.alongSeam())
		return angleOf(directionInPlane(triangles, shaped, flat, grain.direction()));
	if (longestSide[0] >= 0)
		return angleOf(flat.col(longestSide[1]) - flat.col(longestSide[0]));
	const std::vector<int> corners(triangles.flat.reshaped().begin(), triangles.flat.reshaped().end());
	return angleOf(principalDirection(flat(Eigen::all, corners)));
}

StrainedTriangles strainedTriangles(const PatchAssembly& assembly, const Positions& model,
									const FlatPatterns& patterns) {
	StrainedTriangles triangles;
	triangles.shaped = assembly.trianglePlaces;
	triangles.flat = patterns.triangles;
	triangles.weights.resize(triangles.count());
	for (int t = 0; t < triangles.count(); ++t) {
		triangles.weights[t] = triangleFrame(model, assembly.trianglePlaces.col(t)).normal.norm();
		const Eigen::Matrix<double, 2, 3> flat = patterns.positions(Eigen::all, triangles.flat.col(t));
		const Eigen::Vector2d a = flat.col(1) - flat.col(0), b = flat.col(2) - flat.col(0);
		if (a[0] * b[1] - a[1] * b[0] < 0) {
			std::swap(triangles.shaped(1, t), triangles.shaped(2, t));
			std::swap(triangles.flat(1, t), triangles.flat(2, t));
		}
	}
	triangles.weights /= triangles.weights.sum();
	if (patterns.bounds.directed)
		triangles.grain = grainOfTriangles(assembly, model, patterns, triangles);
	return triangles;
}

Eigen::VectorXd beyondBounds(const PatchAssembly& assembly, const Positions& model,
							 const FlatPatterns& patterns) {
	const StrainedTriangles triangles = strainedTriangles(assembly, model, patterns);
	if (!patterns.bounds.any())
		return Eigen::VectorXd::Zero(triangles.count());
	return StrainPenalty(triangles, patterns.bounds, 0).violations(model, patterns.positions);
}

StrainedTriangles trianglesOfPiece(const StrainedTriangles& all, const PatchAssembly& assembly, int piece) {
	std::vector<int> kept;
	for (int t = 0; t < all.count(); ++t)
		if (assembly.patchOfTriangle[t] == piece)
			kept.push_back(t);
	StrainedTriangles triangles;
	triangles.shaped = all.shaped(Eigen::all, kept);
	triangles.flat = all.flat(Eigen::all, kept);
	triangles.weights = all.weights(kept);
	return triangles;
}

} // namespace developable
